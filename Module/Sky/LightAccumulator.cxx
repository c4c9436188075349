// SPDX-License-Identifier: BSD-3-Clause
// In a part of a swath, light comes from above the elevation e of the horizon or of the plane,
// whichever is higher. This takes, per post, sin e, cos^2 e and D(e) (LightTable.h), which are
// computed for vectors of posts; and one line of the table, six vectors of four colours, which is
// applied post by post: neighbouring posts use different lines, but their three colours share one.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Sky/LightAccumulator.cxx"
#include "hwy/foreach_target.h"

#include "Shared/FastMath-inl.h"
#include "Sky/LightAccumulator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "hwy/highway.h"

#ifndef skyline_LightAccumulator_run
#define skyline_LightAccumulator_run
namespace skyline
{

/// Number of posts that are processed together; their data fit into the first-level cache.
constexpr std::ptrdiff_t LightBlock = 64;

/// Up to LightBlock neighbouring posts. The arrays have the length of a whole block.
struct LightRun
{
  const float* Before; ///< sines of the horizons of the previous azimuth, or those of this one
  const float* Here;   ///< sines of the horizons of this azimuth
  const float* East;   ///< gradients; null for level receivers
  const float* North;
  float* Sums; ///< red, green, blue and an unused value for each post
};

/// A part of a swath, and its centre.
struct LightPart
{
  float Sin, Cos, Place;
  std::ptrdiff_t Count; ///< number of lines of the table
  float LinesPerRadian;
  const float* Lines;
};

} // namespace skyline
#endif

HWY_BEFORE_NAMESPACE();
namespace skyline
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;
using LightTag = hn::CappedTag<float, 16>;
using ColorTag = hn::CappedTag<float, 4>;

/// Sines of the elevations of slopes; slopes below 0 count as 0. Always computes a whole block.
void SinesOfSlopes(const float* slopes, std::ptrdiff_t count, float* sines)
{
  const LightTag d;
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  const auto one = hn::Set(d, 1.0f);
  const auto steepest = hn::Set(d, -NoTerrainSlope);
  for (std::ptrdiff_t i = 0; i < count; i += lanes)
  {
    const auto t = hn::Min(hn::Max(hn::Load(d, slopes + i), hn::Zero(d)), steepest);
    hn::Store(hn::Mul(t, hn::Sqrt(hn::Div(one, hn::MulAdd(t, t, one)))), d, sines + i);
  }
}

/// Adds the light of a part to the posts from 0 to count, a multiple of the vector length.
template <bool Tilted>
HWY_NOINLINE void LightBlockOf(const LightPart& part, const LightRun& run, std::ptrdiff_t count)
{
  const LightTag d;
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  const auto zero = hn::Zero(d);
  const auto one = hn::Set(d, 1.0f);
  const auto place = hn::Set(d, part.Place);
  const auto perRadian = hn::Set(d, part.LinesPerRadian);
  const hn::RebindToSigned<LightTag> di;
  const auto last = hn::Set(di, static_cast<std::int32_t>(part.Count - 1));
  alignas(64) float square[LightBlock];
  alignas(64) float bow[LightBlock];
  alignas(64) std::int32_t line[LightBlock];
  for (std::ptrdiff_t i = 0; i < count; i += lanes)
  {
    const auto before = hn::Load(d, run.Before + i);
    auto sine = hn::MulAdd(place, hn::Sub(hn::Load(d, run.Here + i), before), before);
    if (Tilted)
    {
      // The plane of the receiver hides what lies below it.
      const auto rise = hn::MulAdd(hn::Load(d, run.East + i), hn::Set(d, part.Sin),
        hn::Mul(hn::Load(d, run.North + i), hn::Set(d, part.Cos)));
      const auto inverse = hn::Sqrt(hn::Div(one, hn::MulAdd(rise, rise, one)));
      sine = hn::Max(sine, hn::Mul(rise, inverse));
    }
    sine = hn::Min(hn::Max(sine, zero), one);
    const auto cosSquare = hn::Mul(hn::Sub(one, sine), hn::Add(one, sine));
    const auto cosine = hn::Sqrt(cosSquare);
    const auto arc = AsinLow(d, hn::Min(sine, cosine), hn::Min(hn::Mul(sine, sine), cosSquare));
    const auto zenith = hn::IfThenElse(
      hn::Lt(sine, cosine), hn::Sub(hn::Set(d, static_cast<float>(0.5 * Pi)), arc), arc);
    hn::Store(cosSquare, d, square + i);
    hn::Store(hn::NegMulAdd(sine, cosine, zenith), d, bow + i);
    // Gradients of missing posts are NaN, and any line of the table serves for these posts.
    const auto number = hn::ConvertTo(di, hn::Mul(zenith, perRadian));
    hn::Store(hn::Min(hn::Max(number, hn::Zero(di)), last), di, line + i);
  }

  const ColorTag colors;
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    // One iteration if vectors hold four floats.
    for (std::size_t k = 0; k < 4; k += hn::Lanes(colors))
    {
      const float* at = part.Lines + line[i] * LightTable::LineSize + k;
      const auto c = hn::Set(colors, square[i]);
      auto sum = hn::MulAdd(c, hn::LoadU(colors, at + 4), hn::LoadU(colors, at));
      if (Tilted)
      {
        const auto b = hn::Set(colors, bow[i]);
        const auto along = hn::MulAdd(b, hn::LoadU(colors, at + 12), hn::LoadU(colors, at + 8));
        const auto across = hn::MulAdd(b, hn::LoadU(colors, at + 20), hn::LoadU(colors, at + 16));
        sum = hn::NegMulAdd(hn::Set(colors, run.East[i]), along, sum);
        sum = hn::NegMulAdd(hn::Set(colors, run.North[i]), across, sum);
      }
      float* to = run.Sums + 4 * i + k;
      hn::Store(hn::Add(hn::Load(colors, to), sum), colors, to);
    }
  }
}

void LightPosts(const LightPart& part, const LightRun& run, std::ptrdiff_t count)
{
  if (run.East)
  {
    LightBlockOf<true>(part, run, count);
  }
  else
  {
    LightBlockOf<false>(part, run, count);
  }
}
} // namespace HWY_NAMESPACE
} // namespace skyline
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace skyline
{

HWY_EXPORT(SinesOfSlopes);
HWY_EXPORT(LightPosts);

namespace
{

constexpr double Turn = 2.0 * Pi;

} // namespace

LightAccumulator::LightAccumulator(std::ptrdiff_t columns, std::ptrdiff_t rows,
  const std::vector<TurnedLightMap>& maps, const std::vector<double>& azimuths,
  const Options& options, const float* east, const float* north, float* irradiance)
  : Columns(columns)
  , Rows(rows)
  , Maps(maps)
  , Azimuths(azimuths)
  , Settings(options)
  , East(east)
  , North(north)
  , Irradiance(irradiance)
{
  const auto posts = static_cast<std::size_t>(columns * rows);
  std::fill_n(irradiance, 3 * posts, 0.0f);
  const bool linear = options.Quadrature == SwathQuadrature::Linear;
  this->Parts.resize(linear ? static_cast<std::size_t>(options.Parts) : 1);
  for (Part& part : this->Parts)
  {
    part.Tables.resize(maps.size());
  }
  if (linear)
  {
    this->Previous.reset(new float[posts]);
  }
}

std::vector<double> LightAccumulator::HorizonAzimuths() const
{
  std::vector<double> fed = this->Azimuths;
  if (this->Settings.Quadrature == SwathQuadrature::Linear)
  {
    fed.push_back(fed.front() + Turn);
  }
  return fed;
}

/// Azimuth k of the infinite periodic sequence around the circle.
double LightAccumulator::Neighbour(std::ptrdiff_t k) const
{
  const auto count = static_cast<std::ptrdiff_t>(this->Azimuths.size());
  const std::ptrdiff_t turns = k >= 0 ? k / count : -((count - 1 - k) / count);
  return this->Azimuths[static_cast<std::size_t>(k - turns * count)] +
    Turn * static_cast<double>(turns);
}

void LightAccumulator::BuildTables(
  const SwathPiece* begin, const SwathPiece* end, double middle, float place)
{
  Part& part = this->Parts[this->UsedParts++];
  for (std::size_t m = 0; m < this->Maps.size(); ++m)
  {
    part.Tables[m].Build(this->Maps[m], begin, end);
  }
  part.Sin = static_cast<float>(std::sin(middle));
  part.Cos = static_cast<float>(std::cos(middle));
  part.Place = place;
}

void LightAccumulator::Begin(double, double)
{
  ++this->Fed;
  this->UsedParts = 0;
  const double before = this->Neighbour(this->Fed - 1);
  const double here = this->Neighbour(this->Fed);
  const double after = this->Neighbour(this->Fed + 1);
  if (this->Settings.Quadrature == SwathQuadrature::Constant)
  {
    const SwathPiece piece{ 0.5 * (before + here), 0.5 * (here + after), 1.0, 1.0 };
    this->BuildTables(&piece, &piece + 1, here, 1.0f);
  }
  else if (this->Settings.Quadrature == SwathQuadrature::Blend)
  {
    const SwathPiece pieces[2] = { { before, here, 0.0, 1.0 }, { here, after, 1.0, 0.0 } };
    this->BuildTables(pieces, pieces + 2, here, 1.0f);
  }
  else if (this->Fed > 0)
  {
    const int parts = this->Settings.Parts;
    for (int k = 0; k < parts; ++k)
    {
      const double from = before + (here - before) * k / parts;
      const double to = before + (here - before) * (k + 1) / parts;
      const SwathPiece piece{ from, to, 1.0, 1.0 };
      this->BuildTables(
        &piece, &piece + 1, 0.5 * (from + to), (static_cast<float>(k) + 0.5f) / parts);
    }
  }
}

void LightAccumulator::Add(
  std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes)
{
  alignas(64) float copies[5][LightBlock] = {};
  alignas(64) float sums[4 * LightBlock];
  for (std::ptrdiff_t begin = 0; begin < count; begin += LightBlock)
  {
    const std::ptrdiff_t post = row * this->Columns + column + begin;
    const std::ptrdiff_t size = std::min(LightBlock, count - begin);
    // Rounded up to whole vectors of any processor; values after the end of the run are computed
    // but not used.
    const std::ptrdiff_t whole = (size + 15) / 16 * 16;
    const auto copy = [&](const float* from, float* to) { std::copy_n(from, size, to); };
    float* sines = copies[0];
    copy(slopes + begin, copies[1]);
    HWY_DYNAMIC_DISPATCH(SinesOfSlopes)(copies[1], whole, sines);
    LightRun run{ sines, sines, nullptr, nullptr, sums };
    if (this->Previous)
    {
      float* previous = this->Previous.get() + post;
      copy(previous, copies[2]);
      copy(sines, previous);
      run.Before = copies[2];
    }
    if (this->UsedParts == 0)
    {
      continue;
    }
    if (this->East)
    {
      copy(this->East + post, copies[3]);
      copy(this->North + post, copies[4]);
      run.East = copies[3];
      run.North = copies[4];
    }
    std::fill_n(sums, 4 * whole, 0.0f);
    for (std::size_t p = 0; p < this->UsedParts; ++p)
    {
      const Part& part = this->Parts[p];
      for (const LightTable& table : part.Tables)
      {
        if (!table.Dark())
        {
          HWY_DYNAMIC_DISPATCH(LightPosts)
          ({ part.Sin, part.Cos, part.Place, table.LineCount(),
             static_cast<float>(table.LinesPerRadian()), table.Lines() },
            run, whole);
        }
      }
    }
    float* to = this->Irradiance + 3 * post;
    for (std::ptrdiff_t i = 0; i < size; ++i)
    {
      to[3 * i] += sums[4 * i];
      to[3 * i + 1] += sums[4 * i + 1];
      to[3 * i + 2] += sums[4 * i + 2];
    }
  }
}

void LightAccumulator::Finish(std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd)
{
  for (std::ptrdiff_t post = rowBegin * this->Columns; post < rowEnd * this->Columns; ++post)
  {
    const float east = this->East ? this->East[post] : 0.0f;
    const float north = this->East ? this->North[post] : 0.0f;
    const float up = 1.0f / std::sqrt(1.0f + east * east + north * north);
    for (int c = 0; c < 3; ++c)
    {
      float& light = this->Irradiance[3 * post + c];
      light *= up;
      light = light < 0.0f ? 0.0f : light; // rounding where hardly any light remains; NaN passes
    }
  }
}

} // namespace skyline
#endif
