// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Kernels/StoreAccumulator.cxx"
#include "hwy/foreach_target.h"

#include "FastMath-inl.h"
#include "StoreAccumulator.h"

#include <algorithm>

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace skyline
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Degrees of slopes from 0 to count, a multiple of the vector; not inlined, so that whole vectors
/// and tails go through the same instructions.
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
  float* out = this->Values + (row * this->Columns + column) * this->PostStride +
    this->Azimuth * this->AzimuthStride;
  if (this->PostStride == 1)
  {
    HWY_DYNAMIC_DISPATCH(ToDegrees)(slopes, count, out);
    return;
  }
  constexpr std::ptrdiff_t Piece = 256;
  float degrees[Piece];
  for (std::ptrdiff_t begin = 0; begin < count; begin += Piece)
  {
    const std::ptrdiff_t size = std::min(Piece, count - begin);
    HWY_DYNAMIC_DISPATCH(ToDegrees)(slopes + begin, size, degrees);
    for (std::ptrdiff_t i = 0; i < size; ++i)
    {
      out[(begin + i) * this->PostStride] = degrees[i];
    }
  }
}

void StoreAccumulator::Finish(std::ptrdiff_t, std::ptrdiff_t) {}

} // namespace skyline
#endif
