// SPDX-License-Identifier: BSD-3-Clause
// In an azimuth a, a plane with the gradient (x, y) has the slope r = x sin a + y cos a and the
// normal nz (-x, -y, 1). A direction of elevation e meets it with the cosine nz (sin e - r cos e),
// which is positive above the slope r. With L for the integrals up to max(h, r, 0)
// (ElevationIntegral.h),
//
//   lost transfer = nz Sum over azimuths  w [L_upward - (x <sin a> + y <cos a>) L_forward]
//
// where w is the azimuthal factor integrated over the swath, and w <..> is that of its product with
// sin a or cos a. Order 0 takes r at the centre of the swath. The irradiance of a uniform sky is
// then pi times the SkyViewFactor of SkyAccumulator.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Harmonics/VisibilityAccumulator.cxx"
#include "hwy/foreach_target.h"

#include "Harmonics/SwathMean.h"
#include "Harmonics/VisibilityAccumulator.h"
#include "Shared/FastMath-inl.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "hwy/highway.h"

#ifndef skyline_VisibilityAccumulator_block
#define skyline_VisibilityAccumulator_block
namespace skyline
{

/// Posts of a row whose coefficients are stored together, coefficient by coefficient.
constexpr std::ptrdiff_t WedgeBlock = 16;

/// Up to 16 posts of a block and their input.
struct WedgePosts
{
  const float* Slopes[WedgeGroup];
  const float* East;
  const float* North;
  float* Sums; // [coefficient][16]
};

} // namespace skyline
#endif

HWY_BEFORE_NAMESPACE();
namespace skyline
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, 16>;
using V = hn::Vec<Tag>;

/// One value for each azimuth of a group.
struct Group
{
  V Of[WedgeGroup];
};

/// The values from which the integrals are computed.
struct GroupTerms
{
  Group Sine, Square, SineCosine, Cosine, Angle;

  HWY_INLINE void Set(int k, V slope)
  {
    const Tag d;
    const SlopeTerms<V> terms = TermsOfSlope(d, slope);
    this->Sine.Of[k] = hn::CopySign(terms.Size, slope);
    this->Square.Of[k] = terms.SinSquare;
    this->Cosine.Of[k] = terms.Cos;
    this->SineCosine.Of[k] = hn::Mul(this->Sine.Of[k], terms.Cos);
    this->Angle.Of[k] = hn::CopySign(SizeOfAngle(d, terms), slope);
  }
};

/// One integral in all azimuths of the group. The four Horner schemes are evaluated in parallel.
HWY_INLINE Group LostOf(const WedgeIntegral& integral, const GroupTerms& terms)
{
  const Tag d;
  Group p;
  const V last = hn::Set(d, integral.Polynomial[integral.Terms - 1]);
  for (V& value : p.Of)
  {
    value = last;
  }
  for (int term = integral.Terms - 2; term >= 0; --term)
  {
    const V coefficient = hn::Set(d, integral.Polynomial[term]);
    for (int k = 0; k < WedgeGroup; ++k)
    {
      p.Of[k] = hn::MulAdd(p.Of[k], terms.Square.Of[k], coefficient);
    }
  }
  const V constant = hn::Set(d, integral.Constant);
  switch (integral.Kind)
  {
    case ElevationKind::Sine:
      for (int k = 0; k < WedgeGroup; ++k)
      {
        p.Of[k] = hn::Mul(p.Of[k], terms.Sine.Of[k]);
      }
      break;
    case ElevationKind::Square:
      for (int k = 0; k < WedgeGroup; ++k)
      {
        p.Of[k] = hn::Mul(p.Of[k], terms.Square.Of[k]);
      }
      break;
    case ElevationKind::SineCosine:
      for (int k = 0; k < WedgeGroup; ++k)
      {
        p.Of[k] = hn::MulAdd(p.Of[k], terms.SineCosine.Of[k], hn::Mul(constant, terms.Angle.Of[k]));
      }
      break;
    case ElevationKind::Cosine:
      for (int k = 0; k < WedgeGroup; ++k)
      {
        p.Of[k] = hn::MulAdd(p.Of[k], terms.Cosine.Of[k], constant);
      }
      break;
  }
  return p;
}

HWY_INLINE void AddTo(bool first, float* sums, V value)
{
  const Tag d;
  hn::StoreU(first ? value : hn::Add(hn::LoadU(d, sums), value), d, sums);
}

/// The part of the weight of a forward integral that depends on the post.
HWY_INLINE V WeightAlong(V east, V north, float eastWeight, float northWeight)
{
  const Tag d;
  return hn::MulAdd(east, hn::Set(d, eastWeight), hn::Mul(north, hn::Set(d, northWeight)));
}

HWY_INLINE void SumVisible(
  const WedgePass& pass, const GroupTerms& terms, std::ptrdiff_t lane, float* sums)
{
  const Tag d;
  const WedgeIntegral* integral = pass.Visible;
  for (int m = 0; m < pass.Bands; ++m)
  {
    for (int l = m; l < pass.Bands; ++l, ++integral)
    {
      const Group lost = LostOf(*integral, terms);
      V plus = hn::Zero(d);
      V minus = hn::Zero(d);
      for (int k = 0; k < WedgeGroup; ++k)
      {
        plus = hn::MulAdd(hn::Set(d, pass.Weights[k].Cosine[m]), lost.Of[k], plus);
        minus = hn::MulAdd(hn::Set(d, pass.Weights[k].Sine[m]), lost.Of[k], minus);
      }
      AddTo(pass.First, sums + HarmonicIndex(l, m) * WedgeBlock + lane, plus);
      if (m > 0)
      {
        AddTo(pass.First, sums + HarmonicIndex(l, -m) * WedgeBlock + lane, minus);
      }
    }
  }
}

HWY_INLINE void SumTransfer(
  const WedgePass& pass, const GroupTerms& terms, V east, V north, std::ptrdiff_t lane, float* sums)
{
  const Tag d;
  const WedgeIntegral* upward = pass.Upward;
  const WedgeIntegral* forward = pass.Forward;
  for (int m = 0; m < pass.Bands; ++m)
  {
    Group along;
    Group alongMinus;
    for (int k = 0; k < WedgeGroup; ++k)
    {
      const WedgeWeights<float>& weights = pass.Weights[k];
      along.Of[k] = WeightAlong(east, north, weights.CosineEast[m], weights.CosineNorth[m]);
      alongMinus.Of[k] = WeightAlong(east, north, weights.SineEast[m], weights.SineNorth[m]);
    }
    for (int l = m; l < pass.Bands; ++l, ++upward, ++forward)
    {
      const Group up = LostOf(*upward, terms);
      const Group ahead = LostOf(*forward, terms);
      V plus = hn::Zero(d);
      V minus = hn::Zero(d);
      for (int k = 0; k < WedgeGroup; ++k)
      {
        plus = hn::MulAdd(hn::Set(d, pass.Weights[k].Cosine[m]), up.Of[k], plus);
        minus = hn::MulAdd(hn::Set(d, pass.Weights[k].Sine[m]), up.Of[k], minus);
        plus = hn::NegMulAdd(along.Of[k], ahead.Of[k], plus);
        minus = hn::NegMulAdd(alongMinus.Of[k], ahead.Of[k], minus);
      }
      AddTo(pass.First, sums + HarmonicIndex(l, m) * WedgeBlock + lane, plus);
      if (m > 0)
      {
        AddTo(pass.First, sums + HarmonicIndex(l, -m) * WedgeBlock + lane, minus);
      }
    }
  }
}

/// Adds to sixteen posts. Not inlined, so that the bits of a post do not depend on its position.
template <bool Transfer>
HWY_NOINLINE void SumBlock(const WedgePass& pass, const WedgePosts& posts)
{
  const Tag d;
  const V steepest = hn::Set(d, -NoTerrainSlope);
  const V lowest = hn::Set(d, pass.Upper ? 0.0f : NoTerrainSlope);
  for (std::ptrdiff_t lane = 0; lane < WedgeBlock;
       lane += static_cast<std::ptrdiff_t>(hn::Lanes(d)))
  {
    V east = hn::Zero(d);
    V north = hn::Zero(d);
    if (Transfer)
    {
      east = hn::LoadU(d, posts.East + lane);
      north = hn::LoadU(d, posts.North + lane);
    }
    GroupTerms terms;
    for (int k = 0; k < WedgeGroup; ++k)
    {
      V slope = hn::Max(hn::LoadU(d, posts.Slopes[k] + lane), lowest);
      if (Transfer)
      {
        const V rise = hn::MulAdd(
          east, hn::Set(d, pass.SinAzimuth[k]), hn::Mul(north, hn::Set(d, pass.CosAzimuth[k])));
        slope = hn::Max(slope, rise);
      }
      terms.Set(k, hn::Min(slope, steepest));
    }
    if (Transfer)
    {
      SumTransfer(pass, terms, east, north, lane, posts.Sums);
    }
    else
    {
      SumVisible(pass, terms, lane, posts.Sums);
    }
  }
}

void SumPosts(const WedgePass& pass, const WedgePosts& posts)
{
  if (pass.Upward)
  {
    SumBlock<true>(pass, posts);
  }
  else
  {
    SumBlock<false>(pass, posts);
  }
}

} // namespace HWY_NAMESPACE
} // namespace skyline
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace skyline
{

HWY_EXPORT(SumPosts);

namespace
{

enum NormalPart
{
  Up,
  ToEast,
  ToNorth
};

WedgeWeights<float> InFloats(const WedgeWeights<double>& from)
{
  WedgeWeights<float> to{};
  for (int m = 0; m < MaxHarmonicBands; ++m)
  {
    to.Cosine[m] = static_cast<float>(from.Cosine[m]);
    to.Sine[m] = static_cast<float>(from.Sine[m]);
    to.CosineEast[m] = static_cast<float>(from.CosineEast[m]);
    to.SineEast[m] = static_cast<float>(from.SineEast[m]);
    to.CosineNorth[m] = static_cast<float>(from.CosineNorth[m]);
    to.SineNorth[m] = static_cast<float>(from.SineNorth[m]);
  }
  return to;
}

std::vector<WedgeIntegral> InFloats(const std::vector<ElevationIntegral>& exact)
{
  std::vector<WedgeIntegral> integrals;
  for (const ElevationIntegral& from : exact)
  {
    WedgeIntegral to{};
    to.Kind = from.Kind;
    to.Terms = from.Terms;
    to.Constant = static_cast<float>(from.Constant);
    for (std::size_t k = 0; k < from.Polynomial.size(); ++k)
    {
      to.Polynomial[k] = static_cast<float>(from.Polynomial[k]);
    }
    if (to.Kind == ElevationKind::Cosine)
    {
      // Makes the loss of level ground exactly 0: this is the sum that the vector code computes for
      // p.
      to.Constant = -to.Polynomial[0];
    }
    integrals.push_back(to);
  }
  return integrals;
}

} // namespace

WedgeWeights<double> WeightsOfSwath(int bands, double azimuth, double width)
{
  WedgeWeights<double> weights{};
  // sin a = cos p and cos a = sin p, so that the products have the orders m - 1 and m + 1.
  for (int m = 0; m < bands; ++m)
  {
    const SwathMean here = MeanOverSwath(m, azimuth, width);
    const SwathMean less = MeanOverSwath(m - 1, azimuth, width);
    const SwathMean more = MeanOverSwath(m + 1, azimuth, width);
    weights.Cosine[m] = width * here.Cosine;
    weights.Sine[m] = width * here.Sine;
    weights.CosineEast[m] = 0.5 * width * (less.Cosine + more.Cosine);
    weights.SineEast[m] = 0.5 * width * (more.Sine + less.Sine);
    weights.CosineNorth[m] = 0.5 * width * (more.Sine - less.Sine);
    weights.SineNorth[m] = 0.5 * width * (less.Cosine - more.Cosine);
  }
  weights.CosineEast[0] = width * std::sin(azimuth);
  weights.CosineNorth[0] = width * std::cos(azimuth);
  return weights;
}

VisibilityAccumulator::VisibilityAccumulator(
  const HarmonicBuffers& buffers, const float* east, const float* north)
  : Buffers(buffers)
  , East(east)
  , North(north)
{
  if (buffers.Bands < 1 || buffers.Bands > MaxHarmonicBands)
  {
    throw std::invalid_argument(std::to_string(buffers.Bands) +
      " bands of spherical harmonics; give 1 to " + std::to_string(MaxHarmonicBands));
  }
  for (const ElevationWeight weight :
    { ElevationWeight::One, ElevationWeight::Upward, ElevationWeight::Forward })
  {
    const auto index = static_cast<std::size_t>(weight);
    this->Exact[index] = ElevationIntegrals(buffers.Bands, weight);
    this->Integrals[index] = InFloats(this->Exact[index]);
  }
  this->Pass.Bands = buffers.Bands;
  this->Pass.Upper = buffers.Sky == SkyPart::Upper;
  this->Pass.First = true;
  this->Pass.Visible = this->Integrals[0].data();
  this->Pass.Upward = east ? this->Integrals[1].data() : nullptr;
  this->Pass.Forward = east ? this->Integrals[2].data() : nullptr;
  this->Slopes.resize(
    static_cast<std::size_t>((WedgeGroup - 1) * this->Buffers.Columns * this->Buffers.Rows));
}

void VisibilityAccumulator::Begin(double azimuth, double width)
{
  ++this->Waiting;
  if (this->Waiting == WedgeGroup)
  {
    this->Waiting = 0;
    this->Pass.First = false; // the previous group has been added
  }
  if (this->Waiting == 0)
  {
    // A missing azimuth of the group has no weight.
    std::fill_n(this->Pass.Weights, WedgeGroup, WedgeWeights<float>());
  }
  const WedgeWeights<double> weights = WeightsOfSwath(this->Buffers.Bands, azimuth, width);
  this->Pass.Weights[this->Waiting] = InFloats(weights);
  this->Pass.SinAzimuth[this->Waiting] = static_cast<float>(std::sin(azimuth));
  this->Pass.CosAzimuth[this->Waiting] = static_cast<float>(std::cos(azimuth));
  this->AddWhole(weights);
}

void VisibilityAccumulator::AddWhole(const WedgeWeights<double>& weights)
{
  std::size_t index = 0;
  for (int m = 0; m < this->Buffers.Bands; ++m)
  {
    for (int l = m; l < this->Buffers.Bands; ++l, ++index)
    {
      const auto plus = static_cast<std::size_t>(HarmonicIndex(l, m));
      const auto minus = static_cast<std::size_t>(HarmonicIndex(l, -m));
      const auto add = [&](NormalPart part, double value, double cosine, double sine)
      {
        this->Whole[part][plus] += value * cosine;
        this->Whole[part][minus] += m > 0 ? value * sine : 0.0;
      };
      if (this->East == nullptr)
      {
        add(Up, this->Exact[0][index].Whole, weights.Cosine[m], weights.Sine[m]);
        continue;
      }
      const double forward = this->Exact[2][index].Whole;
      add(Up, this->Exact[1][index].Whole, weights.Cosine[m], weights.Sine[m]);
      add(ToEast, -forward, weights.CosineEast[m], weights.SineEast[m]);
      add(ToNorth, -forward, weights.CosineNorth[m], weights.SineNorth[m]);
    }
  }
}

void VisibilityAccumulator::Add(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes)
{
  if (this->Waiting == WedgeGroup - 1)
  {
    this->Sum(row, column, count, slopes);
    return;
  }
  const std::ptrdiff_t posts = this->Buffers.Columns * this->Buffers.Rows;
  std::copy_n(slopes, count,
    this->Slopes.begin() + this->Waiting * posts + row * this->Buffers.Columns + column);
}

/// Adds a whole group. slopes: of its last azimuth; null if the group has no last azimuth.
void VisibilityAccumulator::Sum(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes)
{
  const std::ptrdiff_t columns = this->Buffers.Columns;
  const std::ptrdiff_t posts = columns * this->Buffers.Rows;
  const std::ptrdiff_t coefficients = HarmonicCount(this->Buffers.Bands);
  const float nothing[WedgeBlock] = {};
  const float* slopesOf[WedgeGroup];
  for (int k = 0; k + 1 < WedgeGroup; ++k)
  {
    slopesOf[k] = k <= this->Waiting ? this->Slopes.data() + k * posts + row * columns : nullptr;
  }
  slopesOf[WedgeGroup - 1] = slopes ? slopes - column : nullptr;
  const float* gradients[2] = { this->East ? this->East + row * columns : nullptr,
    this->North ? this->North + row * columns : nullptr };
  float* sums = this->Buffers.Values + row * columns * coefficients;

  for (std::ptrdiff_t begin = column; begin < column + count;)
  {
    const std::ptrdiff_t block = begin / WedgeBlock * WedgeBlock;
    const std::ptrdiff_t width = std::min(WedgeBlock, columns - block); // in memory
    const std::ptrdiff_t end = std::min(block + width, column + count);
    WedgePosts task;
    if (end - begin == WedgeBlock)
    {
      for (int k = 0; k < WedgeGroup; ++k)
      {
        task.Slopes[k] = slopesOf[k] ? slopesOf[k] + begin : nothing;
      }
      task.East = gradients[0] + (gradients[0] ? begin : 0);
      task.North = gradients[1] + (gradients[1] ? begin : 0);
      task.Sums = sums + block * coefficients;
      HWY_DYNAMIC_DISPATCH(SumPosts)(this->Pass, task);
      begin = end;
      continue;
    }
    // Copies are needed, because other posts of the block may belong to another thread.
    alignas(64) float inputs[WedgeGroup + 2][WedgeBlock] = {};
    alignas(64) float copies[HarmonicCount(MaxHarmonicBands) * WedgeBlock];
    const std::ptrdiff_t size = end - begin;
    const auto copyIn = [&](const float* from, float* to) -> const float*
    {
      if (from)
      {
        std::copy_n(from + begin, size, to);
      }
      return to;
    };
    for (int k = 0; k < WedgeGroup; ++k)
    {
      task.Slopes[k] = copyIn(slopesOf[k], inputs[k]);
    }
    task.East = copyIn(gradients[0], inputs[WedgeGroup]);
    task.North = copyIn(gradients[1], inputs[WedgeGroup + 1]);
    task.Sums = copies;
    float* own = sums + block * coefficients + (begin - block);
    std::fill(copies, copies + coefficients * WedgeBlock, 0.0f);
    for (std::ptrdiff_t c = 0; !this->Pass.First && c < coefficients; ++c)
    {
      std::copy_n(own + c * width, size, copies + c * WedgeBlock);
    }
    HWY_DYNAMIC_DISPATCH(SumPosts)(this->Pass, task);
    for (std::ptrdiff_t c = 0; c < coefficients; ++c)
    {
      std::copy_n(copies + c * WedgeBlock, size, own + c * width);
    }
    begin = end;
  }
}

void VisibilityAccumulator::Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd)
{
  const std::ptrdiff_t columns = this->Buffers.Columns;
  if (this->Waiting < 0)
  {
    const std::ptrdiff_t row = columns * HarmonicCount(this->Buffers.Bands);
    std::fill(this->Buffers.Values + rowBegin * row, this->Buffers.Values + rowEnd * row, 0.0f);
    return;
  }
  for (std::ptrdiff_t row = rowBegin; row < rowEnd; ++row)
  {
    if (this->Waiting < WedgeGroup - 1)
    {
      this->Sum(row, 0, columns, nullptr);
    }
    for (std::ptrdiff_t column = 0; column < columns; column += WedgeBlock)
    {
      this->FinishBlock(row, column, std::min(WedgeBlock, columns - column));
    }
  }
}

/// Converts what is lost to what is left, and the order from coefficient by coefficient to post by
/// post.
void VisibilityAccumulator::FinishBlock(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t posts) const
{
  const std::ptrdiff_t coefficients = HarmonicCount(this->Buffers.Bands);
  const std::ptrdiff_t first = row * this->Buffers.Columns + column;
  float* values = this->Buffers.Values + first * coefficients;
  float lost[HarmonicCount(MaxHarmonicBands) * WedgeBlock];
  std::copy_n(values, coefficients * posts, lost);
  for (std::ptrdiff_t post = 0; post < posts; ++post)
  {
    const double east = this->East ? this->East[first + post] : 0.0;
    const double north = this->East ? this->North[first + post] : 0.0;
    const double up = 1.0 / std::sqrt(1.0 + east * east + north * north);
    for (std::ptrdiff_t c = 0; c < coefficients; ++c)
    {
      const auto index = static_cast<std::size_t>(c);
      const double whole = this->Whole[Up][index] + east * this->Whole[ToEast][index] +
        north * this->Whole[ToNorth][index];
      *values++ = static_cast<float>(up * (whole - lost[c * posts + post]));
    }
  }
}

} // namespace skyline
#endif
