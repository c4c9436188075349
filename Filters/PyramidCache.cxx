// SPDX-License-Identifier: BSD-3-Clause
#include "PyramidCache.h"

#include "HeightField/HeightPyramid.h"
#include "vtkSMPTools.h"

namespace skyline
{

std::shared_ptr<const HeightPyramid> PyramidCache::Get(
  const HeightField& field, std::uint64_t checksum, double levelStep, bool& built)
{
  built = !this->Pyramid || this->LevelStep != levelStep || this->Checksum != checksum;
  if (built)
  {
    this->Pyramid = nullptr; // frees its memory first
    const auto pyramid = std::make_shared<HeightPyramid>(field, levelStep);
    vtkSMPTools::For(
      0, pyramid->RowCount(), [&](vtkIdType begin, vtkIdType end) { pyramid->Expand(begin, end); });
    this->Pyramid = pyramid;
    this->Checksum = checksum;
    this->LevelStep = levelStep;
  }
  return this->Pyramid;
}

} // namespace skyline
