// SPDX-License-Identifier: BSD-3-Clause
// A pyramid of heights, kept between executions as long as the heights are the same.
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
  /// The pyramid of the field, with all of its rows built; a new one if the field's checksum
  /// (HeightChecksum) or the number of levels to an octave changed. built: whether it is new.
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
