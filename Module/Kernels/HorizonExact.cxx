// SPDX-License-Identifier: BSD-3-Clause
// The exact horizon: every edge near the receiver, and beyond it only the segments of lines whose
// convex bound says that they can raise the horizon of a receiver of the block.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Kernels/HorizonExact.cxx"
#include "hwy/foreach_target.h"

#include "FindTask.h"
#include "HorizonExact.h"
#include "RayWalk-inl.h"

#include "hwy/highway.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace skyline
{
namespace HWY_NAMESPACE
{

// ---- bounds: see SegmentBounds -------------------------------------------------------------------

void BuildBounds(ExactState& state, std::ptrdiff_t group)
{
  const Lanes tag;
  const std::ptrdiff_t width = VectorWidth();
  const RayFrame& frame = *state.Frame;
  SegmentBounds& bounds = state.Bounds;
  const std::ptrdiff_t laneBegin = -ExactState::BoundMargin;
  const std::ptrdiff_t laneEnd = frame.Lanes + ExactState::BoundMargin;
  const Vector support = hn::Set(tag, state.Support);
  const std::ptrdiff_t segmentBegin = group * SegmentBounds::PerGroup;
  const std::ptrdiff_t segmentEnd =
    std::min(segmentBegin + SegmentBounds::PerGroup, bounds.Segments);

  for (std::ptrdiff_t segment = segmentBegin; segment < segmentEnd; ++segment)
  {
    const std::ptrdiff_t near = segment * SegmentBounds::Lines;
    const std::ptrdiff_t lines = std::min(SegmentBounds::Lines, frame.Lines - 1 - near);
    float* level = bounds.Level(segment);
    float* tilted = bounds.Tilted(segment);
    for (std::ptrdiff_t lane = laneBegin; lane < laneEnd; lane += width)
    {
      Vector top = hn::Set(tag, MissingHeight);
      Vector leaning = top;
      for (std::ptrdiff_t e = 0; e <= lines; ++e)
      {
        const SegmentReach& reach = state.Reach[static_cast<std::size_t>(e)];
        const float* post = frame.Heights + (near + e) * frame.LineStride + lane;
        Vector high = hn::LoadU(tag, post + reach.First);
        for (std::ptrdiff_t j = reach.First + 1; j <= reach.Last; ++j)
        {
          high = hn::Max(high, hn::LoadU(tag, post + j));
        }
        top = hn::Max(top, high);
        leaning =
          hn::Max(leaning, hn::NegMulAdd(support, hn::Set(tag, static_cast<float>(e)), high));
      }
      hn::StoreU(top, tag, level + lane);
      hn::StoreU(leaning, tag, tilted + lane);
    }
  }

  float* level = bounds.GroupLevel(group);
  float* tilted = bounds.GroupTilted(group);
  for (std::ptrdiff_t lane = laneBegin; lane < laneEnd; lane += width)
  {
    Vector top = hn::Set(tag, MissingHeight);
    Vector leaning = top;
    for (std::ptrdiff_t segment = segmentBegin; segment < segmentEnd; ++segment)
    {
      const std::ptrdiff_t e = (segment - segmentBegin) * SegmentBounds::Lines;
      const double drift = frame.Slant * static_cast<double>(e);
      const std::ptrdiff_t whole = frame.DriftAfter(e);
      const std::ptrdiff_t further = whole + (drift > static_cast<double>(whole) ? 1 : 0);
      // A lane whose reach leaves the bounds' own margin holds no data there.
      const std::ptrdiff_t a = std::clamp(lane + frame.Drift * whole, laneBegin, laneEnd);
      const std::ptrdiff_t b = std::clamp(lane + frame.Drift * further, laneBegin, laneEnd);
      const Vector offset = hn::Set(tag, state.Support * static_cast<float>(e));
      top = hn::Max(top,
        hn::Max(hn::LoadU(tag, bounds.Level(segment) + a), hn::LoadU(tag, bounds.Level(segment) + b)));
      leaning = hn::Max(leaning,
        hn::Sub(hn::Max(hn::LoadU(tag, bounds.Tilted(segment) + a),
                  hn::LoadU(tag, bounds.Tilted(segment) + b)),
          offset));
    }
    hn::StoreU(top, tag, level + lane);
    hn::StoreU(leaning, tag, tilted + lane);
  }
}

// ---- search --------------------------------------------------------------------------------------

/// What the tests of a block share: they change only when the horizon of a receiver rises.
struct BlockTest
{
  HWY_INLINE BlockTest(const ExactState& state, const Block& heights)
    : State(state)
    , Heights(Each(
        [&](Vector h) { return hn::Add(h, hn::Set(Lanes(), state.Rounding)); }, heights))
  {
  }

  /// best: metres per line so far. lines: length of what is tested.
  HWY_INLINE void Update(const Block& best, float lines)
  {
    const Vector zero = hn::Zero(Lanes());
    const Vector one = hn::Set(Lanes(), 1.0f);
    const Vector tolerance = hn::Set(Lanes(), this->State.TolerancePerLine);
    const Vector inverse = hn::Set(Lanes(), this->State.SupportInverse);
    const Vector length = hn::Set(Lanes(), lines);
    this->Slope = Each([&](Vector g) { return hn::Add(g, tolerance); }, best);
    this->Blend = Each(
      [&](Vector g) { return hn::Min(hn::Max(hn::Mul(g, inverse), zero), one); }, this->Slope);
    // A slope below 0 would be passed under by up to the whole length.
    this->Threshold =
      Each([&](Vector g, Vector h) { return hn::MulAdd(hn::Min(g, zero), length, h); },
        this->Slope, this->Heights);
  }

  /// True if a receiver of the block may gain from what these bounds bound, `line` lines ahead.
  HWY_INLINE bool MayGain(const float* level, const float* tilted, float line, float sink) const
  {
    const Vector lines = hn::Set(Lanes(), line);
    const Vector sunk = hn::Set(Lanes(), sink);
    const Block top = Load(level);
    const Block bound =
      Each([](Vector blend, Vector t, Vector l) { return hn::MulAdd(blend, hn::Sub(t, l), l); },
        this->Blend, Load(tilted), top);
    const Block needed =
      Each([&](Vector g, Vector t) { return hn::MulAdd(g, lines, hn::Add(t, sunk)); },
        this->Slope, this->Threshold);
    return AnyGreater(bound, needed);
  }

  const ExactState& State;
  Block Heights;
  Block Slope = Same(0.0f);
  Block Blend = Same(0.0f);
  Block Threshold = Same(0.0f);
};

/// The horizons of one block of receivers on one line.
template <Walk Kind>
HWY_INLINE Block FindBlock(const ExactState& state, std::ptrdiff_t line, std::ptrdiff_t lane,
  std::ptrdiff_t last, const Block& heights, SegmentHints& hints)
{
  const RayFrame& frame = *state.Frame;
  const SegmentBounds& bounds = state.Bounds;
  constexpr std::ptrdiff_t lines = SegmentBounds::Lines;
  constexpr std::ptrdiff_t perGroup = SegmentBounds::PerGroup;
  const float* origin = frame.Heights + line * frame.LineStride + lane;
  const std::ptrdiff_t firstSegment = (line + ExactState::NearLines + lines - 1) / lines;
  const std::ptrdiff_t nearLast = std::min(firstSegment * lines - line, last);
  Block best =
    WalkSteps<Kind>(frame, origin, heights, Same(MissingHeight), 1, nearLast);
  if (nearLast == last)
  {
    return best;
  }
  const std::ptrdiff_t lastSegment = (line + last - 1) / lines;
  BlockTest test(state, heights);
  SegmentHints found;
  const auto visitIfGain = [&](std::ptrdiff_t segment) {
    const std::ptrdiff_t from = segment * lines - line;
    const std::ptrdiff_t at = lane + state.EntryLane(from);
    if (!test.MayGain(bounds.Level(segment) + at, bounds.Tilted(segment) + at,
          static_cast<float>(from), state.SinkAt(from)))
    {
      return;
    }
    const Block raised =
      WalkSteps<Kind>(frame, origin, heights, best, from + 1, std::min(from + lines, last));
    if (AnyGreater(raised, best))
    {
      best = raised;
      found.Add(static_cast<std::int32_t>(segment));
      test.Update(best, static_cast<float>(lines));
    }
  };

  test.Update(best, static_cast<float>(lines));
  for (std::int32_t hint : hints.Segments)
  {
    if (hint >= firstSegment && hint <= lastSegment)
    {
      visitIfGain(hint);
    }
  }
  const std::ptrdiff_t firstGroup = firstSegment / perGroup;
  const std::ptrdiff_t lastGroup = lastSegment / perGroup;
  for (std::ptrdiff_t chunk = firstGroup; chunk <= lastGroup; chunk += 64)
  {
    test.Update(best, static_cast<float>(lines * perGroup));
    std::uint64_t groups = 0;
    const std::ptrdiff_t chunkEnd = std::min(chunk + 63, lastGroup);
    for (std::ptrdiff_t group = chunk; group <= chunkEnd; ++group)
    {
      const std::ptrdiff_t from = std::max<std::ptrdiff_t>(group * perGroup * lines - line, 0);
      const std::ptrdiff_t at = lane + state.EntryLane(from);
      const bool may = test.MayGain(bounds.GroupLevel(group) + at, bounds.GroupTilted(group) + at,
        static_cast<float>(from), state.SinkAt(from));
      groups |= static_cast<std::uint64_t>(may) << (group - chunk);
    }
    if (chunk == firstGroup && firstGroup * perGroup * lines <= line)
    {
      groups |= 1;
    }
    while (groups != 0)
    {
      const std::ptrdiff_t group = chunk + __builtin_ctzll(groups);
      groups &= groups - 1;
      test.Update(best, static_cast<float>(lines));
      const std::ptrdiff_t begin = std::max(group * perGroup, firstSegment);
      const std::ptrdiff_t end = std::min((group + 1) * perGroup - 1, lastSegment);
      std::uint64_t segments = 0;
      for (std::ptrdiff_t segment = begin; segment <= end; ++segment)
      {
        const std::ptrdiff_t from = segment * lines - line;
        const std::ptrdiff_t at = lane + state.EntryLane(from);
        const bool may = test.MayGain(bounds.Level(segment) + at, bounds.Tilted(segment) + at,
          static_cast<float>(from), state.SinkAt(from));
        segments |= static_cast<std::uint64_t>(may) << (segment - begin);
      }
      // The bounds of a winner stay above its own horizon: once walked, it is done.
      for (std::int32_t hint : hints.Segments)
      {
        if (hint >= begin && hint <= end)
        {
          segments &= ~(std::uint64_t{ 1 } << (hint - begin));
        }
      }
      while (segments != 0)
      {
        const std::ptrdiff_t segment = begin + __builtin_ctzll(segments);
        segments &= segments - 1;
        visitIfGain(segment);
      }
    }
  }
  hints = found;
  return best;
}

template <Walk Kind>
void FindLanes(const ExactState& state, const FindTask& task)
{
  const std::ptrdiff_t width = BlockWidth();
  const RayFrame& frame = *state.Frame;
  // Block by block, and lines against the rays inside: the posts ahead stay in the first cache, and
  // the segments that won for the line just found usually win again.
  for (std::ptrdiff_t lane = task.LaneBegin; lane < task.LaneEnd; lane += width)
  {
    const std::ptrdiff_t leaves = frame.LastStep(lane, width);
    SegmentHints hints;
    for (std::ptrdiff_t line = task.LineEnd - 1; line >= task.LineBegin; --line)
    {
      const Block heights = Load(task.Receivers[line - task.LineBegin] + lane);
      const Block best = FindBlock<Kind>(
        state, line, lane, std::min(frame.Lines - 1 - line, leaves), heights, hints);
      StoreSlopes(best, state.LinesPerMetre,
        task.Slopes + (line - task.LineBegin) * task.Stride + (lane - task.LaneBegin));
    }
  }
}

void FindAlong(const ExactState& state, const FindTask& task)
{
  FindLanes<Walk::Along>(state, task);
}
void FindAgainst(const ExactState& state, const FindTask& task)
{
  FindLanes<Walk::Against>(state, task);
}
void FindHoles(const ExactState& state, const FindTask& task)
{
  FindLanes<Walk::Holes>(state, task);
}
void FindBilinear(const ExactState& state, const FindTask& task)
{
  FindLanes<Walk::Bilinear>(state, task);
}

} // namespace HWY_NAMESPACE
} // namespace skyline
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace skyline
{

HWY_EXPORT(BuildBounds);
HWY_EXPORT(FindAlong);
HWY_EXPORT(FindAgainst);
HWY_EXPORT(FindHoles);
HWY_EXPORT(FindBilinear);

HorizonExact::HorizonExact(const HeightField& field, const HorizonSettings& settings)
  : Field(field)
  , Settings(settings)
{
}

void HorizonExact::SetAzimuth(const Grid& grid, double azimuth)
{
  this->Ray = std::make_unique<RayFrame>(this->Field, grid, azimuth, this->Settings.Sink);
  const bool corners = this->Ray->Against || this->Field.HasMissing() ||
    this->Settings.Shape == Surface::Bilinear;
  this->State.Set(*this->Ray, corners, this->Settings.Tolerance, this->Field.LargestHeight());
}

std::ptrdiff_t HorizonExact::PrepareCount() const
{
  return this->State.Bounds.Groups;
}

void HorizonExact::Prepare(std::ptrdiff_t begin, std::ptrdiff_t end)
{
  for (std::ptrdiff_t group = begin; group < end; ++group)
  {
    HWY_DYNAMIC_DISPATCH(BuildBounds)(this->State, group);
  }
}

void HorizonExact::Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
  std::ptrdiff_t laneEnd, float* slopes, std::ptrdiff_t stride) const
{
  const FindTask task(
    this->Field, *this->Ray, lineBegin, lineEnd, laneBegin, laneEnd, slopes, stride);
  if (this->Settings.Shape == Surface::Bilinear)
  {
    HWY_DYNAMIC_DISPATCH(FindBilinear)(this->State, task);
  }
  else if (this->Field.HasMissing())
  {
    HWY_DYNAMIC_DISPATCH(FindHoles)(this->State, task);
  }
  else if (this->Ray->Against)
  {
    HWY_DYNAMIC_DISPATCH(FindAgainst)(this->State, task);
  }
  else
  {
    HWY_DYNAMIC_DISPATCH(FindAlong)(this->State, task);
  }
}

} // namespace skyline
#endif
