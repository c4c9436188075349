// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Horizon/HorizonPyramid.cxx"
#include "hwy/foreach_target.h"

#include "Horizon/HorizonPyramid.h"
#include "Shared/FastMath-inl.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "hwy/contrib/math/math-inl.h"
#include "hwy/highway.h"

#ifndef skyline_HorizonPyramid_task
#define skyline_HorizonPyramid_task
namespace skyline
{

/// Rows of a level with their weights, for the bicubic B-spline along the other axis.
struct RowTaps
{
  int Count = 0;
  const float* Rows[8] = {};
  const float* Coverage[8] = {};
  float Weights[8] = {};
};

/// One level for one line of receivers.
struct LevelTask
{
  RowTaps Receiver, Caster;
  float Near = 1.0f, Far = 0.0f;     // weights of the two columns of the caster
  std::ptrdiff_t Shift = 0;          // lanes to the first of these columns
  std::ptrdiff_t Begin = 0, End = 0; // lanes whose caster lies in the data
  float InverseDistance = 1.0f;      // 1 / m
  float Drop = 0.0f;                 // lowering of the caster by curvature, as a slope
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

// A caster counts as terrain if half of its sample is covered; a receiver if any part is.
constexpr float CasterCoverage = 0.5f;
constexpr float ReceiverCoverage = 1.0e-6f;

// Vectors that are computed together, so that values common to all lanes are loaded once for all of
// them.
constexpr std::ptrdiff_t Side = 4;

template <std::ptrdiff_t Count>
struct Vectors
{
  V Of[Count];
};

/// Sums over the rows of taps, starting at a lane.
template <std::ptrdiff_t Count>
HWY_INLINE Vectors<Count> SumAt(const RowTaps& taps, const float* const* rows, std::ptrdiff_t lane)
{
  const Tag d;
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  Vectors<Count> sums;
  for (V& sum : sums.Of)
  {
    sum = hn::Zero(d);
  }
  for (int tap = 0; tap < taps.Count; ++tap)
  {
    const V weight = hn::Set(d, taps.Weights[tap]);
    const float* values = rows[tap] + lane;
    for (std::ptrdiff_t v = 0; v < Count; ++v)
    {
      sums.Of[v] = hn::MulAdd(weight, hn::LoadU(d, values + v * lanes), sums.Of[v]);
    }
  }
  return sums;
}

/// The same, interpolated between two columns.
HWY_INLINE Vectors<Side> SumBetween(
  const LevelTask& task, const float* const* rows, std::ptrdiff_t lane)
{
  const Tag d;
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  const auto near = SumAt<Side + 1>(task.Caster, rows, lane + task.Shift);
  alignas(64) float columns[(Side + 1) * 16];
  for (std::ptrdiff_t v = 0; v <= Side; ++v)
  {
    hn::Store(near.Of[v], d, columns + v * lanes);
  }
  Vectors<Side> sums;
  for (std::ptrdiff_t v = 0; v < Side; ++v)
  {
    const V far = hn::LoadU(d, columns + v * lanes + 1);
    sums.Of[v] = hn::MulAdd(hn::Set(d, task.Far), far, hn::Mul(hn::Set(d, task.Near), near.Of[v]));
  }
  return sums;
}

/// Sets the slope to 0 in those lanes of a vector whose caster lies outside the data.
HWY_INLINE V KeepInside(const LevelTask& task, std::ptrdiff_t lane, V slope)
{
  const Tag d;
  if (lane >= task.Begin && lane + static_cast<std::ptrdiff_t>(hn::Lanes(d)) <= task.End)
  {
    return slope;
  }
  const V place = hn::Iota(d, 0.0f);
  const auto inside = hn::And(hn::Ge(place, hn::Set(d, static_cast<float>(task.Begin - lane))),
    hn::Lt(place, hn::Set(d, static_cast<float>(task.End - lane))));
  return hn::IfThenElseZero(inside, slope);
}

/// The derivative of one level (SN08, equation 2); 0 if it is negative or without terrain.
template <bool Missing>
HWY_INLINE Vectors<Side> SlopesOf(const LevelTask& task, std::ptrdiff_t lane)
{
  const Tag d;
  const V zero = hn::Zero(d);
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  Vectors<Side> slopes;
  if (lane >= task.End || lane + Side * lanes <= task.Begin)
  {
    for (V& slope : slopes.Of)
    {
      slope = zero;
    }
    return slopes;
  }
  Vectors<Side> from = SumAt<Side>(task.Receiver, task.Receiver.Rows, lane);
  Vectors<Side> to = SumBetween(task, task.Caster.Rows, lane);
  Vectors<Side> here, there;
  if (Missing)
  {
    here = SumAt<Side>(task.Receiver, task.Receiver.Coverage, lane);
    there = SumBetween(task, task.Caster.Coverage, lane);
  }
  const V leastHere = hn::Set(d, ReceiverCoverage);
  const V leastThere = hn::Set(d, CasterCoverage);
  for (std::ptrdiff_t v = 0; v < Side; ++v)
  {
    if (Missing)
    {
      from.Of[v] = hn::Div(from.Of[v], hn::Max(here.Of[v], leastHere));
      to.Of[v] = hn::Div(to.Of[v], hn::Max(there.Of[v], leastThere));
    }
    V slope = hn::MulSub(
      hn::Sub(to.Of[v], from.Of[v]), hn::Set(d, task.InverseDistance), hn::Set(d, task.Drop));
    slope = hn::Max(slope, zero);
    if (Missing)
    {
      slope = hn::IfThenElseZero(
        hn::And(hn::Ge(here.Of[v], leastHere), hn::Ge(there.Of[v], leastThere)), slope);
    }
    slopes.Of[v] = KeepInside(task, lane + v * lanes, slope);
  }
  return slopes;
}

/// The greatest value, at the knots and halfway between them, of the cubic B-spline through a
/// sequence of angles whose ends are repeated (SN08, equations 4 and 5). Shift adds the next angle.
struct SplineMaximum
{
  V First, Second, Third; // the last three values of the sequence
  V Best;

  HWY_INLINE void Start(V value)
  {
    this->First = this->Second = this->Third = value; // the first value is repeated
    this->Best = hn::Zero(Tag());
  }
  HWY_INLINE void Shift(V value, bool half)
  {
    const Tag d;
    const V knot = hn::MulAdd(hn::Set(d, 4.0f), this->Third, hn::Add(this->Second, value));
    this->Best = hn::Max(this->Best, hn::Mul(hn::Set(d, 1.0f / 6.0f), knot));
    if (half)
    {
      const V between = hn::MulAdd(
        hn::Set(d, 23.0f), hn::Add(this->Second, this->Third), hn::Add(this->First, value));
      this->Best = hn::Max(this->Best, hn::Mul(hn::Set(d, 1.0f / 48.0f), between));
    }
    this->First = this->Second;
    this->Second = this->Third;
    this->Third = value;
  }
};

HWY_INLINE V AngleOf(V slope)
{
  const Tag d;
  return hn::AllFalse(d, hn::Gt(slope, hn::Zero(d)))
    ? hn::Zero(d)
    : AtanIn(d, slope, 1.0f, static_cast<float>(0.5 * Pi));
}

template <bool Missing>
HWY_INLINE Vectors<Side> SplineHorizon(
  const LevelTask* tasks, std::size_t levels, std::ptrdiff_t lane)
{
  const Tag d;
  SplineMaximum splines[Side];
  const Vectors<Side> first = SlopesOf<Missing>(tasks[0], lane);
  for (std::ptrdiff_t v = 0; v < Side; ++v)
  {
    splines[v].Start(AngleOf(first.Of[v]));
  }
  for (std::size_t i = 1; i < levels; ++i)
  {
    const Vectors<Side> slopes = SlopesOf<Missing>(tasks[i], lane);
    for (std::ptrdiff_t v = 0; v < Side; ++v)
    {
      splines[v].Shift(AngleOf(slopes.Of[v]), i > 1);
    }
  }
  Vectors<Side> horizon;
  for (std::ptrdiff_t v = 0; v < Side; ++v)
  {
    SplineMaximum& spline = splines[v];
    spline.Shift(spline.Third, levels > 1);
    const V least = hn::Set(d, 1.0e-9f);
    horizon.Of[v] = hn::Div(hn::Sin(d, spline.Best), hn::Max(hn::Cos(d, spline.Best), least));
  }
  return horizon;
}

template <bool Missing>
HWY_INLINE Vectors<Side> GreatestHorizon(
  const LevelTask* tasks, std::size_t levels, std::ptrdiff_t lane)
{
  Vectors<Side> best = SlopesOf<Missing>(tasks[0], lane);
  for (std::size_t i = 1; i < levels; ++i)
  {
    const Vectors<Side> slopes = SlopesOf<Missing>(tasks[i], lane);
    for (std::ptrdiff_t v = 0; v < Side; ++v)
    {
      best.Of[v] = hn::Max(best.Of[v], slopes.Of[v]);
    }
  }
  return best;
}

/// Computes the slopes of lanes [begin, end) of a line, in whole vectors.
template <bool Missing, bool Spline>
HWY_NOINLINE void FindLanes(const LevelTask* tasks, std::size_t levels, std::ptrdiff_t begin,
  std::ptrdiff_t end, float* slopes)
{
  const Tag d;
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  for (std::ptrdiff_t lane = begin; lane < end; lane += Side * lanes)
  {
    const Vectors<Side> found = Spline ? SplineHorizon<Missing>(tasks, levels, lane)
                                       : GreatestHorizon<Missing>(tasks, levels, lane);
    for (std::ptrdiff_t v = 0; v < Side && lane + v * lanes < end; ++v)
    {
      hn::StoreU(found.Of[v], d, slopes + (lane - begin) + v * lanes);
    }
  }
}

void FindLine(const std::vector<LevelTask>& tasks, bool missing, bool spline, std::ptrdiff_t begin,
  std::ptrdiff_t end, float* slopes)
{
  const auto find = missing ? (spline ? FindLanes<true, true> : FindLanes<true, false>)
                            : (spline ? FindLanes<false, true> : FindLanes<false, false>);
  find(tasks.data(), tasks.size(), begin, end, slopes);
}

} // namespace HWY_NAMESPACE
} // namespace skyline
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace skyline
{

HWY_EXPORT(FindLine);

namespace
{

void AddTap(
  const HeightPyramid& pyramid, int level, std::ptrdiff_t sample, float weight, RowTaps& taps)
{
  const float* values = pyramid.Row(level, sample);
  int tap = 0;
  while (tap < taps.Count && taps.Rows[tap] != values)
  {
    ++tap;
  }
  if (tap == taps.Count)
  {
    ++taps.Count;
    taps.Rows[tap] = values;
    taps.Coverage[tap] = pyramid.HasMissing() ? pyramid.CoverageRow(level, sample) : nullptr;
  }
  taps.Weights[tap] += weight;
}

/// Adds the taps of a row of posts, multiplied by a weight. If a row is already present, its weight
/// grows.
void AddRow(
  const HeightPyramid& pyramid, int level, std::ptrdiff_t row, double weight, RowTaps& taps)
{
  const auto share = static_cast<float>(weight);
  if (level == pyramid.Levels() - 1)
  {
    AddTap(pyramid, level, row, share, taps); // unsmoothed heights of the field
    return;
  }
  const SplineTaps& spline = pyramid.RowTaps(level, row);
  for (std::size_t k = 0; k < spline.Weights.size(); ++k)
  {
    AddTap(pyramid, level, spline.Samples[k], spline.Weights[k] * share, taps);
  }
}

/// Sets the range of lanes whose caster, `shift` posts away, lies in the data.
void SetLanes(double shift, std::ptrdiff_t columns, LevelTask& task)
{
  constexpr double snap = 1.0e-9; // tolerance of the offset, in posts
  const double last = static_cast<double>(columns - 1);
  const double begin = std::max(0.0, std::ceil(-shift - snap));
  const double end = std::min(last, std::floor(last - shift + snap)) + 1.0;
  task.Begin = static_cast<std::ptrdiff_t>(begin);
  task.End = static_cast<std::ptrdiff_t>(std::max(end, 0.0));
}

LevelTask TaskOf(const HeightPyramid& pyramid, const PyramidReach& reach, double drop,
  std::ptrdiff_t columns, std::ptrdiff_t rows, std::ptrdiff_t row)
{
  LevelTask task;
  const double there = static_cast<double>(row) + reach.North;
  const double low = std::floor(there + 1.0e-9);
  if (low < 0.0 || there > static_cast<double>(rows - 1) + 1.0e-9)
  {
    return task; // an empty range of lanes
  }
  SetLanes(reach.East, columns, task);
  if (task.Begin >= task.End)
  {
    task.Begin = task.End = 0;
    return task;
  }
  AddRow(pyramid, reach.Level, row, 1.0, task.Receiver);
  const double part = std::max(0.0, there - low);
  const auto lowRow = static_cast<std::ptrdiff_t>(low);
  AddRow(pyramid, reach.Level, lowRow, 1.0 - part, task.Caster);
  if (part > 1.0e-9)
  {
    AddRow(pyramid, reach.Level, lowRow + 1, part, task.Caster);
  }
  const double left = std::floor(reach.East + 1.0e-9);
  task.Shift = static_cast<std::ptrdiff_t>(left);
  task.Far = static_cast<float>(std::max(0.0, reach.East - left));
  task.Near = 1.0f - task.Far;
  task.InverseDistance = static_cast<float>(1.0 / reach.Distance);
  task.Drop = static_cast<float>(drop * reach.Distance);
  return task;
}

} // namespace

void CheckPyramidSettings(const PyramidSettings& settings)
{
  if (!(settings.LevelOffset >= 0.0 && settings.LevelOffset <= 64.0))
  {
    throw std::invalid_argument("the pyramid's level offset is " +
      std::to_string(settings.LevelOffset) + " octaves; give 0 to 64");
  }
  if (!(settings.Distance > 0.0 && settings.Distance <= 64.0))
  {
    throw std::invalid_argument("the pyramid reads " + std::to_string(settings.Distance) +
      " samples away; give more than 0 and at most 64");
  }
}

std::vector<PyramidReach> PyramidReaches(
  const HeightPyramid& pyramid, const PyramidSettings& settings, const Grid& grid, double azimuth)
{
  std::vector<PyramidSize> levels;
  for (int i = 0; i < pyramid.Levels(); ++i)
  {
    const PyramidLevel& level = pyramid.Level(i);
    levels.push_back({ level.Scale, level.Columns, level.Rows });
  }
  return PyramidReaches(levels, settings, grid, azimuth);
}

std::vector<PyramidReach> PyramidReaches(const std::vector<PyramidSize>& levels,
  const PyramidSettings& settings, const Grid& grid, double azimuth)
{
  const PostsPerMetre ray = RayOfAzimuth(grid, azimuth);
  const double east = ray.Columns;
  const double north = ray.Rows;
  const double metresPerPost = 1.0 / std::hypot(east, north);
  std::vector<PyramidReach> reaches;
  const double finest = static_cast<double>(levels.size()) - 1.0;
  for (const PyramidSize& level : levels)
  {
    const auto i = static_cast<double>(reaches.size());
    const double sharper = std::ceil(i + settings.LevelStep * settings.LevelOffset - 1.0e-9);
    PyramidReach reach;
    reach.Level = static_cast<int>(std::min(sharper, finest));
    reach.Distance = settings.Distance * level.Scale * metresPerPost;
    reach.East = reach.Distance * east;
    reach.North = reach.Distance * north;
    reaches.push_back(reach);
  }
  return reaches;
}

HorizonPyramid::HorizonPyramid(const HeightField& field, const HorizonSettings& settings,
  std::shared_ptr<const HeightPyramid> pyramid)
  : Settings(settings)
  , Own(pyramid ? nullptr : std::make_shared<HeightPyramid>(field, settings.Pyramid.LevelStep))
  , Pyramid(pyramid ? std::move(pyramid) : this->Own)
  , Columns(field.Posts().Columns)
  , Rows(field.Posts().Rows)
{
  CheckPyramidSettings(settings.Pyramid);
  // Lines are rows in every azimuth, as in the frame for north.
  this->Ray = std::make_unique<RayFrame>(field, field.Posts(), 0.0, settings.CurvatureDrop);
}

void HorizonPyramid::SetAzimuth(const Grid& grid, double azimuth)
{
  this->Pieces = this->Own && this->Reach.empty() ? this->Pyramid->RowCount() : 0;
  this->Reach = PyramidReaches(*this->Pyramid, this->Settings.Pyramid, grid, azimuth);
}

void HorizonPyramid::Prepare(std::ptrdiff_t begin, std::ptrdiff_t end)
{
  this->Own->Expand(begin, end);
}

void HorizonPyramid::Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd,
  std::ptrdiff_t laneBegin, std::ptrdiff_t laneEnd, float* slopes, std::ptrdiff_t stride) const
{
  std::vector<LevelTask> tasks(this->Reach.size());
  const std::ptrdiff_t whole = laneBegin + (laneEnd - laneBegin + 15) / 16 * 16;
  for (std::ptrdiff_t line = lineBegin; line < lineEnd; ++line)
  {
    std::transform(this->Reach.begin(), this->Reach.end(), tasks.begin(),
      [&](const PyramidReach& reach)
      {
        return TaskOf(*this->Pyramid, reach, this->Settings.CurvatureDrop, this->Columns,
          this->Rows, this->Ray->ImageLine(line));
      });
    HWY_DYNAMIC_DISPATCH(FindLine)
    (tasks, this->Pyramid->HasMissing(), this->Settings.Pyramid.Spline, laneBegin, whole,
      slopes + (line - lineBegin) * stride);
  }
}

} // namespace skyline
#endif
