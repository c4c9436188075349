// SPDX-License-Identifier: BSD-3-Clause
// Keeps a pyramid of heights between executions as long as the heights are the same.
#ifndef skyline_PyramidCache_h
#define skyline_PyramidCache_h

#include <cstdint>
#include <memory>

namespace skyline
{

class HeightField;
class HeightPyramid;

class PyramidCache
{
public:
  /// Returns the pyramid of the field with all of its rows. A new pyramid is built if the checksum
  /// of the field (HeightChecksum) or the number of levels per octave has changed; `built` says so.
  std::shared_ptr<const HeightPyramid> Get(
    const HeightField& field, std::uint64_t checksum, double levelStep, bool& built);

  void Clear() { this->Pyramid = nullptr; }
  bool Empty() const { return !this->Pyramid; }

private:
  std::shared_ptr<const HeightPyramid> Pyramid;
  std::uint64_t Checksum = 0;
  double LevelStep = 0.0;
};

} // namespace skyline

#endif
