// SPDX-License-Identifier: BSD-3-Clause
// In an azimuth with the horizon h, a plane with the slope g (rise per metre in this azimuth) has
// the normal nz (-g, 1). A direction of elevation e is lit with nz (sin e - g cos e) and lies above
// the plane if tan e > g. With t = tan max(h, ...), the lower end of the light, a swath of width w
// contributes:
//
//   SkyViewFactor  1/pi w nz Int_h^90 (sin e - g cos e) cos e de
//                = w / 2 pi nz [1 - sin^2 h - g (acot t - t cos^2 h)],   t = max(tan h, g, 0)
//   UniformAmbient the same with t = max(tan h, g) and the cosine's mean over the swath:
//                  g times sin(w / 2) / (w / 2); this is TW10's equation 5 in slopes
//   horizontal   = w / 2 pi [1 - sin^2 h],                               t = max(tan h, 0)
//   visible      = w / 2 pi [1 - sin h]
//   openness     = w / 2 pi [90 degrees - h]
//
// The sums contain what is lost, that is the brackets without their 1, so that open level ground
// gives exactly 1. nz is the same for all azimuths and is applied last.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Sky/SkyAccumulator.cxx"
#include "hwy/foreach_target.h"

#include "Shared/FastMath-inl.h"
#include "Sky/SkyAccumulator.h"

#include <algorithm>
#include <cmath>

#include "hwy/highway.h"

#ifndef skyline_SkyAccumulator_run
#define skyline_SkyAccumulator_run
namespace skyline
{

enum SkyQuantity
{
  Tilted,
  Horizontal,
  Visible,
  Openness,
  Ambient,
  SkyQuantities
};

/// A run of posts that are neighbours in memory; null for quantities that are not computed.
struct SkyRun
{
  const float* Slopes = nullptr;
  const float* East = nullptr;
  const float* North = nullptr;
  float* Sums[SkyQuantities] = {};
};

struct SkyAzimuth
{
  float Sin, Cos, Weight, AmbientWeight;
  bool First;
};

} // namespace skyline
#endif

HWY_BEFORE_NAMESPACE();
namespace skyline
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// The sums of one quantity for a vector of posts. The constructor reads and Write is separate, so
/// that all sums are read before any is written: the buffers are often a multiple of 4096 bytes
/// apart, and then a load waits for an earlier store to the same position in another page.
struct VectorOfSums
{
  using Tag = hn::CappedTag<float, 16>;
  using V = hn::Vec<Tag>;

  HWY_INLINE VectorOfSums(float* sums, bool first, std::ptrdiff_t i)
    : Sums(sums ? sums + i : nullptr)
    , Value(sums && !first ? hn::LoadU(Tag(), sums + i) : hn::Zero(Tag()))
  {
  }
  HWY_INLINE void Write() const
  {
    if (this->Sums)
    {
      hn::StoreU(this->Value, Tag(), this->Sums);
    }
  }

  float* Sums;
  V Value;
};

/// Adds to the posts of the run from 0 to count, a multiple of the vector length. Not inlined:
/// whole vectors and tails use the same instructions, so that the bits of a post do not depend on
/// its position in a run.
template <bool OnLevel, bool OnTilted, bool OnAmbient>
HWY_NOINLINE void AddVectors(const SkyAzimuth& azimuth, const SkyRun& run, std::ptrdiff_t count)
{
  const VectorOfSums::Tag d;
  using V = VectorOfSums::V;
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  const V zero = hn::Zero(d);
  const V steepest = hn::Set(d, -NoTerrainSlope);
  const V weight = hn::Set(d, azimuth.Weight);
  const V sine = hn::Set(d, azimuth.Sin);
  const V cosine = hn::Set(d, azimuth.Cos);
  const V ambientWeight = hn::Set(d, azimuth.AmbientWeight);
  const bool first = azimuth.First;

  for (std::ptrdiff_t i = 0; i < count; i += lanes)
  {
    VectorOfSums horizontal(OnLevel ? run.Sums[Horizontal] : nullptr, first, i);
    VectorOfSums visible(OnLevel ? run.Sums[Visible] : nullptr, first, i);
    VectorOfSums openness(OnLevel ? run.Sums[Openness] : nullptr, first, i);
    VectorOfSums tilted(OnTilted ? run.Sums[Tilted] : nullptr, first, i);
    VectorOfSums ambient(OnAmbient ? run.Sums[Ambient] : nullptr, first, i);

    const V slope = hn::Min(hn::LoadU(d, run.Slopes + i), steepest);
    if (OnLevel)
    {
      const SlopeTerms<V> terms = TermsOfSlope(d, slope);
      const auto up = hn::Gt(slope, zero);
      const V angle = hn::CopySign(SizeOfAngle(d, terms), slope);
      horizontal.Value =
        hn::MulAdd(weight, hn::IfThenElseZero(up, terms.SinSquare), horizontal.Value);
      visible.Value = hn::MulAdd(weight, hn::IfThenElseZero(up, terms.Size), visible.Value);
      openness.Value = hn::MulAdd(weight, angle, openness.Value);
    }
    if (OnTilted || OnAmbient)
    {
      const V rise =
        hn::MulAdd(hn::LoadU(d, run.East + i), sine, hn::Mul(hn::LoadU(d, run.North + i), cosine));
      const V end = hn::Min(hn::Max(slope, rise), steepest);
      if (OnTilted)
      {
        const V above = hn::Max(end, zero);
        const SlopeTerms<V> terms = TermsOfSlope(d, above);
        const V along = hn::NegMulAdd(above, terms.CosSquare, ZenithAngle(d, terms));
        tilted.Value = hn::MulAdd(weight, hn::MulAdd(rise, along, terms.SinSquare), tilted.Value);
      }
      if (OnAmbient)
      {
        const SlopeTerms<V> terms = TermsOfSlope(d, end);
        // For a slope below 0, acot is greater than a right angle.
        const V zenith = ZenithAngle(d, terms);
        const V beyond = hn::Sub(hn::Set(d, static_cast<float>(Pi)), zenith);
        const V along =
          hn::NegMulAdd(end, terms.CosSquare, hn::IfThenElse(hn::Lt(end, zero), beyond, zenith));
        ambient.Value = hn::MulAdd(
          weight, terms.SinSquare, hn::MulAdd(hn::Mul(ambientWeight, rise), along, ambient.Value));
      }
    }
    horizontal.Write();
    visible.Write();
    openness.Write();
    tilted.Write();
    ambient.Write();
  }
}

using AddFunction = void (*)(const SkyAzimuth&, const SkyRun&, std::ptrdiff_t);

/// Chooses the instance that computes the quantities of the run.
AddFunction ChooseAdd(const SkyRun& run)
{
  static constexpr AddFunction table[2][2][2] = {
    { { AddVectors<false, false, false>, AddVectors<false, false, true> },
      { AddVectors<false, true, false>, AddVectors<false, true, true> } },
    { { AddVectors<true, false, false>, AddVectors<true, false, true> },
      { AddVectors<true, true, false>, AddVectors<true, true, true> } }
  };
  const bool level = run.Sums[Horizontal] || run.Sums[Visible] || run.Sums[Openness];
  return table[level][run.Sums[Tilted] != nullptr][run.Sums[Ambient] != nullptr];
}

/// Adds to the last posts of a run, which do not fill a vector, using a copy.
HWY_NOINLINE void AddRest(const SkyAzimuth& azimuth, const SkyRun& run, std::ptrdiff_t whole,
  std::ptrdiff_t rest, AddFunction add)
{
  alignas(64) float inputs[3][16] = {};
  alignas(64) float sums[SkyQuantities][16] = {};
  SkyRun tail;
  const auto copyIn = [&](const float* from, float* to) -> const float*
  {
    if (from)
    {
      std::copy_n(from + whole, rest, to);
    }
    return from ? to : nullptr;
  };
  tail.Slopes = copyIn(run.Slopes, inputs[0]);
  tail.East = copyIn(run.East, inputs[1]);
  tail.North = copyIn(run.North, inputs[2]);
  for (int q = 0; q < SkyQuantities; ++q)
  {
    tail.Sums[q] = run.Sums[q] ? sums[q] : nullptr;
    if (run.Sums[q] && !azimuth.First)
    {
      std::copy_n(run.Sums[q] + whole, rest, sums[q]);
    }
  }
  add(azimuth, tail, static_cast<std::ptrdiff_t>(hn::Lanes(VectorOfSums::Tag())));
  for (int q = 0; q < SkyQuantities; ++q)
  {
    if (run.Sums[q])
    {
      std::copy_n(sums[q], rest, run.Sums[q] + whole);
    }
  }
}

/// Adds to the posts of the run from 0 to count.
void AddRun(const SkyAzimuth& azimuth, const SkyRun& run, std::ptrdiff_t count)
{
  const VectorOfSums::Tag d;
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  const std::ptrdiff_t whole = count / lanes * lanes;
  const std::ptrdiff_t rest = count - whole;
  const AddFunction add = ChooseAdd(run);
  if (whole > 0)
  {
    add(azimuth, run, whole);
  }
  if (rest > 0)
  {
    AddRest(azimuth, run, whole, rest, add);
  }
}
} // namespace HWY_NAMESPACE
} // namespace skyline
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace skyline
{

HWY_EXPORT(AddRun);

SkyAccumulator::SkyAccumulator(
  std::ptrdiff_t columns, const SkyBuffers& buffers, const float* east, const float* north)
  : Columns(columns)
  , Buffers(buffers)
  , East(east)
  , North(north)
{
  for (const PostBuffer* buffer : { &buffers.SkyViewFactor, &buffers.SkyViewFactorHorizontal,
         &buffers.VisibleSkyFraction, &buffers.PositiveOpenness, &buffers.UniformAmbient })
  {
    this->Strided = this->Strided || (buffer->Values && buffer->Stride != 1);
  }
}

void SkyAccumulator::Begin(double azimuth, double width)
{
  this->First = this->Total == 0.0;
  this->Weight = width / (2.0 * Pi);
  this->Total += this->Weight;
  this->SinAzimuth = static_cast<float>(std::sin(azimuth));
  this->CosAzimuth = static_cast<float>(std::cos(azimuth));
  this->AmbientWeight = static_cast<float>(std::sin(0.5 * width) / Pi);
}

void SkyAccumulator::Add(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes)
{
  if (this->Strided)
  {
    this->AddStrided(row * this->Columns + column, count, slopes);
    return;
  }
  const std::ptrdiff_t post = row * this->Columns + column;
  const auto at = [post](float* values) { return values ? values + post : nullptr; };
  SkyRun run;
  run.Slopes = slopes;
  run.East = this->East ? this->East + post : nullptr;
  run.North = this->North ? this->North + post : nullptr;
  run.Sums[Tilted] = at(this->Buffers.SkyViewFactor.Values);
  run.Sums[Horizontal] = at(this->Buffers.SkyViewFactorHorizontal.Values);
  run.Sums[Visible] = at(this->Buffers.VisibleSkyFraction.Values);
  run.Sums[Openness] = at(this->Buffers.PositiveOpenness.Values);
  run.Sums[Ambient] = at(this->Buffers.UniformAmbient.Values);
  HWY_DYNAMIC_DISPATCH(AddRun)(this->Azimuth(), run, count);
}

/// Sums that are not contiguous in memory are copied to contiguous memory and back, in pieces that
/// fit into the cache.
void SkyAccumulator::AddStrided(std::ptrdiff_t post, std::ptrdiff_t count, const float* slopes)
{
  const PostBuffer* buffers[SkyQuantities] = { &this->Buffers.SkyViewFactor,
    &this->Buffers.SkyViewFactorHorizontal, &this->Buffers.VisibleSkyFraction,
    &this->Buffers.PositiveOpenness, &this->Buffers.UniformAmbient };
  constexpr std::ptrdiff_t Piece = 256;
  float copies[SkyQuantities][Piece];
  for (std::ptrdiff_t begin = 0; begin < count; begin += Piece)
  {
    const std::ptrdiff_t size = std::min(Piece, count - begin);
    SkyRun run;
    run.Slopes = slopes + begin;
    run.East = this->East ? this->East + post + begin : nullptr;
    run.North = this->North ? this->North + post + begin : nullptr;
    for (int q = 0; q < SkyQuantities; ++q)
    {
      run.Sums[q] = buffers[q]->Values ? copies[q] : nullptr;
      for (std::ptrdiff_t i = 0; run.Sums[q] && !this->First && i < size; ++i)
      {
        copies[q][i] = buffers[q]->Values[(post + begin + i) * buffers[q]->Stride];
      }
    }
    HWY_DYNAMIC_DISPATCH(AddRun)(this->Azimuth(), run, size);
    for (int q = 0; q < SkyQuantities; ++q)
    {
      for (std::ptrdiff_t i = 0; run.Sums[q] && i < size; ++i)
      {
        buffers[q]->Values[(post + begin + i) * buffers[q]->Stride] = copies[q][i];
      }
    }
  }
}

SkyAzimuth SkyAccumulator::Azimuth() const
{
  return { this->SinAzimuth, this->CosAzimuth, static_cast<float>(this->Weight),
    this->AmbientWeight, this->First };
}

void SkyAccumulator::Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd)
{
  const auto total = static_cast<float>(this->Total);
  const auto each = [&](const PostBuffer& buffer, auto&& result)
  {
    if (buffer.Values)
    {
      for (std::ptrdiff_t post = rowBegin * this->Columns; post < rowEnd * this->Columns; ++post)
      {
        float& value = buffer.Values[post * buffer.Stride];
        value = result(post, value);
      }
    }
  };
  // Rounding may move a sum slightly out of its range. NaN passes both comparisons.
  const auto share = [](float value) { return value < 0.0f ? 0.0f : value > 1.0f ? 1.0f : value; };
  const auto plane = [&](std::ptrdiff_t post, float lost)
  {
    const double east = this->East[post];
    const double north = this->North[post];
    const double up = 1.0 / std::sqrt(1.0 + east * east + north * north);
    return share(static_cast<float>(up * (this->Total - lost)));
  };
  each(this->Buffers.SkyViewFactor, plane);
  each(this->Buffers.UniformAmbient, plane);
  each(this->Buffers.SkyViewFactorHorizontal,
    [&](std::ptrdiff_t, float lost) { return share(total - lost); });
  each(this->Buffers.VisibleSkyFraction,
    [&](std::ptrdiff_t, float lost) { return share(total - lost); });
  each(this->Buffers.PositiveOpenness,
    [&](std::ptrdiff_t, float sum)
    { return static_cast<float>(90.0 * this->Total - DegreesPerRadian * sum); });
}

} // namespace skyline
#endif
