// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Horizon/StoreAccumulator.cxx"
#include "hwy/foreach_target.h"

#include "Horizon/StoreAccumulator.h"
#include "Shared/FastMath-inl.h"

#include <algorithm>
#include <vector>

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace skyline
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Converts the slopes from 0 to count, a multiple of the vector length, to degrees. Not inlined,
/// so that whole vectors and tails use the same instructions.
HWY_NOINLINE void VectorsToDegrees(const float* slopes, std::ptrdiff_t count, float* degrees)
{
  const hn::CappedTag<float, 16> d;
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  for (std::ptrdiff_t i = 0; i < count; i += lanes)
  {
    hn::StoreU(AtanDegrees(d, hn::LoadU(d, slopes + i)), d, degrees + i);
  }
}

void ToDegrees(const float* slopes, std::ptrdiff_t count, float* degrees)
{
  const hn::CappedTag<float, 16> d;
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  const std::ptrdiff_t whole = count / lanes * lanes;
  VectorsToDegrees(slopes, whole, degrees);
  if (whole < count)
  {
    alignas(64) float tail[16] = {};
    std::copy_n(slopes + whole, count - whole, tail);
    VectorsToDegrees(tail, lanes, tail);
    std::copy_n(tail, count - whole, degrees + whole);
  }
}

} // namespace HWY_NAMESPACE
} // namespace skyline
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace skyline
{

HWY_EXPORT(ToDegrees);

namespace
{
// Number of posts whose azimuths are stored together until Finish: 33 cache lines. The odd number
// spreads the azimuths over the sets of the cache when they are converted to tuples.
constexpr std::ptrdiff_t Block = 528;
} // namespace

StoreAccumulator::StoreAccumulator(
  std::ptrdiff_t columns, float* values, std::ptrdiff_t postStride, std::ptrdiff_t azimuthStride)
  : Columns(columns)
  , Values(values)
  , PostStride(postStride)
  , AzimuthStride(azimuthStride)
{
}

void StoreAccumulator::Begin(double, double)
{
  ++this->Azimuth;
}

void StoreAccumulator::Add(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes)
{
  float* line = this->Values + row * this->Columns * this->PostStride;
  if (this->PostStride == 1)
  {
    HWY_DYNAMIC_DISPATCH(ToDegrees)
    (slopes, count, line + column + this->Azimuth * this->AzimuthStride);
    return;
  }
  for (const std::ptrdiff_t end = column + count; column < end;)
  {
    const std::ptrdiff_t block = column / Block * Block;
    const std::ptrdiff_t width = std::min(Block, this->Columns - block);
    const std::ptrdiff_t size = std::min(block + width, end) - column;
    HWY_DYNAMIC_DISPATCH(ToDegrees)
    (slopes, size, line + block * this->PostStride + this->Azimuth * width + (column - block));
    slopes += size;
    column += size;
  }
}

void StoreAccumulator::Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd)
{
  if (this->PostStride == 1)
  {
    return;
  }
  std::vector<float> planes(
    static_cast<std::size_t>(std::min(Block, this->Columns) * this->PostStride));
  for (std::ptrdiff_t row = rowBegin; row < rowEnd; ++row)
  {
    for (std::ptrdiff_t block = 0; block < this->Columns; block += Block)
    {
      const std::ptrdiff_t width = std::min(Block, this->Columns - block);
      float* tuple = this->Values + (row * this->Columns + block) * this->PostStride;
      std::copy_n(tuple, width * this->PostStride, planes.data());
      for (std::ptrdiff_t post = 0; post < width; ++post, tuple += this->PostStride)
      {
        for (std::ptrdiff_t k = 0; k <= this->Azimuth; ++k)
        {
          tuple[k] = planes[static_cast<std::size_t>(k * width + post)];
        }
      }
    }
  }
}

} // namespace skyline
#endif
