// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowHeight/ShadowHeightTiles.h"

namespace skyline
{

void ShadowHeightTiles::Build(const PaddedPlane& plane)
{
  if (!this->FineTiles.empty())
  {
    return;
  }
  const std::ptrdiff_t fineRows = (plane.Lines + Fine - 1) / Fine;
  const std::ptrdiff_t coarseRows = (plane.Lines + Coarse - 1) / Coarse;
  this->FinePerRow = (plane.Lanes + Fine - 1) / Fine;
  this->CoarsePerRow = (plane.Lanes + Coarse - 1) / Coarse;
  this->FineTiles.assign(static_cast<std::size_t>(fineRows * this->FinePerRow), MissingHeight);
  this->CoarseTiles.assign(
    static_cast<std::size_t>(coarseRows * this->CoarsePerRow), MissingHeight);
  std::vector<float> tops(static_cast<std::size_t>(this->FinePerRow * Fine), MissingHeight);
  for (std::ptrdiff_t row = 0; row < fineRows; ++row)
  {
    std::fill(tops.begin(), tops.end(), MissingHeight);
    // The margin of the plane has a missing line on each side.
    const std::ptrdiff_t end = std::min((row + 1) * Fine, plane.Lines - 1);
    for (std::ptrdiff_t line = row * Fine - 1; line <= end; ++line)
    {
      const float* heights = plane.Line(line);
      for (std::ptrdiff_t lane = 0; lane < plane.Lanes; ++lane)
      {
        float& top = tops[static_cast<std::size_t>(lane)];
        top = std::max(top, heights[lane]);
      }
    }
    float* fine = this->FineTiles.data() + row * this->FinePerRow;
    float* coarse = this->CoarseTiles.data() + row / (Coarse / Fine) * this->CoarsePerRow;
    for (std::ptrdiff_t tile = 0; tile < this->FinePerRow; ++tile)
    {
      const auto first = tops.begin() + tile * Fine;
      fine[tile] = *std::max_element(first, first + Fine);
      float& top = coarse[tile / (Coarse / Fine)];
      top = std::max(top, fine[tile]);
      this->Whole = std::max(this->Whole, fine[tile]);
    }
  }
}

} // namespace skyline
