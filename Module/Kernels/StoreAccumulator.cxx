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

namespace
{
constexpr std::ptrdiff_t LineFloats = 16; // floats of a cache line
}

StoreAccumulator::StoreAccumulator(std::ptrdiff_t columns, std::ptrdiff_t rows, float* values,
  std::ptrdiff_t postStride, std::ptrdiff_t azimuthStride)
  : Columns(columns)
  , Posts(columns * rows)
  , Values(values)
  , PostStride(postStride)
  , AzimuthStride(azimuthStride)
  , Batch(std::min(LineFloats, postStride))
{
}

void StoreAccumulator::Begin(double, double)
{
  ++this->Azimuth;
  this->Gathered.resize(static_cast<std::size_t>((this->Batch - 1) * this->Posts));
}

void StoreAccumulator::Add(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes)
{
  const std::ptrdiff_t post = row * this->Columns + column;
  if (this->Batch == 1)
  {
    HWY_DYNAMIC_DISPATCH(ToDegrees)
    (slopes, count, this->Values + post + this->Azimuth * this->AzimuthStride);
    return;
  }
  const std::ptrdiff_t plane = this->Azimuth % this->Batch;
  if (plane < this->Batch - 1)
  {
    HWY_DYNAMIC_DISPATCH(ToDegrees)
    (slopes, count, this->Gathered.data() + plane * this->Posts + post);
    return;
  }
  constexpr std::ptrdiff_t Piece = 256;
  float degrees[Piece];
  for (std::ptrdiff_t begin = 0; begin < count; begin += Piece)
  {
    const std::ptrdiff_t size = std::min(Piece, count - begin);
    HWY_DYNAMIC_DISPATCH(ToDegrees)(slopes + begin, size, degrees);
    this->WriteBatch(post + begin, size, plane);
    float* out =
      this->Values + (post + begin) * this->PostStride + this->Azimuth * this->AzimuthStride;
    for (std::ptrdiff_t i = 0; i < size; ++i)
    {
      out[i * this->PostStride] = degrees[i];
    }
  }
}

void StoreAccumulator::WriteBatch(
  std::ptrdiff_t post, std::ptrdiff_t count, std::ptrdiff_t gathered)
{
  const std::ptrdiff_t first = this->Azimuth / this->Batch * this->Batch;
  const float* planes = this->Gathered.data() + post;
  float* out = this->Values + post * this->PostStride + first * this->AzimuthStride;
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    for (std::ptrdiff_t plane = 0; plane < gathered; ++plane)
    {
      out[i * this->PostStride + plane * this->AzimuthStride] = planes[plane * this->Posts + i];
    }
  }
}

void StoreAccumulator::Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd)
{
  const std::ptrdiff_t gathered = this->Azimuth % this->Batch + 1;
  if (gathered < this->Batch)
  {
    this->WriteBatch(rowBegin * this->Columns, (rowEnd - rowBegin) * this->Columns, gathered);
  }
}

} // namespace skyline
#endif
