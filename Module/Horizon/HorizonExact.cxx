// SPDX-License-Identifier: BSD-3-Clause
// The exact horizon: visits all edges near the receiver, and beyond them only those segments of
// lines whose convex bound shows that they may raise the horizon of a receiver of the block.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Horizon/HorizonExact.cxx"
#include "hwy/foreach_target.h"

#include "HeightField/BaseHeight.h"
#include "Horizon/HorizonExact.h"
#include "Horizon/RayWalk-inl.h"

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
    const ExactState::LaneRange asked = state.LanesAt(near, SegmentBounds::Lines);
    for (std::ptrdiff_t lane = asked.Begin; lane < asked.End; lane += width)
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
  const ExactState::LaneRange asked = state.LanesAt(segmentBegin * SegmentBounds::Lines, 0);
  for (std::ptrdiff_t lane = asked.Begin; lane < asked.End; lane += width)
  {
    Vector top = hn::Set(tag, MissingHeight);
    Vector leaning = top;
    for (std::ptrdiff_t segment = segmentBegin; segment < segmentEnd; ++segment)
    {
      const std::ptrdiff_t e = (segment - segmentBegin) * SegmentBounds::Lines;
      const double drift = frame.Slant * static_cast<double>(e);
      const std::ptrdiff_t whole = frame.DriftAfter(e);
      const std::ptrdiff_t further = whole + (drift > static_cast<double>(whole) ? 1 : 0);
      // A lane whose reach leaves the margin of the bounds has no data there.
      const std::ptrdiff_t a = std::clamp(lane + frame.Drift * whole, laneBegin, laneEnd);
      const std::ptrdiff_t b = std::clamp(lane + frame.Drift * further, laneBegin, laneEnd);
      const Vector offset = hn::Set(tag, state.Support * static_cast<float>(e));
      top = hn::Max(top,
        hn::Max(
          hn::LoadU(tag, bounds.Level(segment) + a), hn::LoadU(tag, bounds.Level(segment) + b)));
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

/// Values that the tests of a block share. They change only when the horizon of a receiver rises.
struct BlockTest
{
  HWY_INLINE BlockTest(const ExactState& state, const Block& heights)
    : State(state)
    , Heights(Each([&](Vector h) { return hn::Add(h, hn::Set(Lanes(), state.Rounding)); }, heights))
  {
  }

  /// best: greatest slopes so far, in metres per line. lines: number of lines that are tested at
  /// once.
  HWY_INLINE void Update(const Block& best, float lines)
  {
    const Vector zero = hn::Zero(Lanes());
    const Vector one = hn::Set(Lanes(), 1.0f);
    const Vector tolerance = hn::Set(Lanes(), this->State.TolerancePerLine);
    const Vector inverse = hn::Set(Lanes(), this->State.SupportInverse);
    const Vector length = hn::Set(Lanes(), lines);
    this->Slope = Each([&](Vector g) { return hn::Add(g, tolerance); }, best);
    this->Blend =
      Each([&](Vector g) { return hn::Min(hn::Max(hn::Mul(g, inverse), zero), one); }, this->Slope);
    // With a slope below 0, the line of sight may descend over the whole length.
    this->Threshold =
      Each([&](Vector g, Vector h) { return hn::MulAdd(hn::Min(g, zero), length, h); }, this->Slope,
        this->Heights);
  }

  /// Returns true if posts under these bounds, whose near edge is `line` lines ahead, may raise the
  /// horizon of a receiver of the block.
  HWY_INLINE bool MayGain(const float* level, const float* tilted, float line, float drop) const
  {
    const Vector lines = hn::Set(Lanes(), line);
    const Vector lowered = hn::Set(Lanes(), drop);
    const Block top = Load(level);
    const Block bound =
      Each([](Vector blend, Vector t, Vector l) { return hn::MulAdd(blend, hn::Sub(t, l), l); },
        this->Blend, Load(tilted), top);
    const Block needed =
      Each([&](Vector g, Vector t) { return hn::MulAdd(g, lines, hn::Add(t, lowered)); },
        this->Slope, this->Threshold);
    return AnyGreater(bound, needed);
  }

  const ExactState& State;
  Block Heights;
  Block Slope = Same(0.0f);
  Block Blend = Same(0.0f);
  Block Threshold = Same(0.0f);
};

/// Searches the horizons of one block of receivers on one line. Holed: steps beside missing posts
/// go cell by cell, the others as if no post were missing.
template <Walk Kind, Body Shape, bool Holed>
struct BlockSearch
{
  static constexpr std::ptrdiff_t Lines = SegmentBounds::Lines;
  static constexpr std::ptrdiff_t PerGroup = SegmentBounds::PerGroup;
  using Bits = std::uint64_t; // one bit per segment or group

  HWY_INLINE BlockSearch(const ExactState& state, std::ptrdiff_t line, std::ptrdiff_t lane,
    std::ptrdiff_t last, const Block& heights)
    : State(state)
    , Origin(state.Frame->Heights + line * state.Frame->LineStride + lane)
    , Line(line)
    , Lane(lane)
    , Last(last)
    , Heights(heights)
    , Test(state, heights)
    , Best(Same(MissingHeight))
  {
  }

  /// Visits all near edges, then the segments that raised the horizon of the previous line, then
  /// all others that may raise it.
  HWY_INLINE Block Run(SegmentHints& hints)
  {
    const std::ptrdiff_t first = (this->Line + ExactState::NearLines + Lines - 1) / Lines;
    const std::ptrdiff_t near = std::min(first * Lines - this->Line, this->Last);
    this->Best = this->WalkLines(this->Line / Lines, 1, near);
    if (near == this->Last)
    {
      return this->Best;
    }
    const std::ptrdiff_t last = (this->Line + this->Last - 1) / Lines;
    for (const std::int32_t hint : hints.Segments)
    {
      if (hint >= first && hint <= last && this->WorthWalking(hint))
      {
        this->WalkSegment(hint);
      }
    }
    const std::ptrdiff_t lastGroup = last / PerGroup;
    for (std::ptrdiff_t begin = first / PerGroup; begin <= lastGroup; begin += 64)
    {
      Bits groups = this->Groups(begin, std::min(begin + 63, lastGroup));
      for (; groups != 0; groups &= groups - 1)
      {
        const std::ptrdiff_t group = begin + LowestBit(groups);
        this->SearchGroup(
          std::max(group * PerGroup, first), std::min((group + 1) * PerGroup - 1, last), hints);
      }
    }
    hints = this->Found;
    return this->Best;
  }

private:
  static HWY_INLINE std::ptrdiff_t LowestBit(Bits bits)
  {
    return static_cast<std::ptrdiff_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(bits));
  }

  /// The greatest slopes after steps first .. last, whose lines begin in `segment`.
  HWY_INLINE Block WalkLines(std::ptrdiff_t segment, std::ptrdiff_t first, std::ptrdiff_t last)
  {
    const RayFrame& frame = *this->State.Frame;
    if (Holed && this->MissingBeside(segment, first, last))
    {
      return WalkSteps<Walk::Holes, Body::Curved>(
        frame, this->Origin, this->Heights, this->Best, first, last);
    }
    return WalkSteps<Kind, Shape>(frame, this->Origin, this->Heights, this->Best, first, last);
  }

  HWY_INLINE bool MissingBeside(
    std::ptrdiff_t segment, std::ptrdiff_t first, std::ptrdiff_t last) const
  {
    const std::ptrdiff_t begin = this->Lane + this->State.Frame->Steps[first - 1].Lane;
    const std::ptrdiff_t end = this->Lane + this->State.Frame->Steps[last].Lane;
    constexpr std::ptrdiff_t reach = 2; // lanes beside the trail posts that a step reads
    const std::ptrdiff_t lastSegment = (this->Line + last - 1) / Lines;
    bool missing = false;
    for (; segment <= lastSegment; ++segment)
    {
      missing |= this->State.Holes.Any(
        segment, std::min(begin, end) - reach, std::max(begin, end) + BlockWidth() + reach);
    }
    return missing;
  }

  /// Whether to visit a segment of the hints: always in an exact search, because hints nearly
  /// always raise the horizon; with a tolerance only after a test, because the gain is often too
  /// small.
  HWY_INLINE bool WorthWalking(std::ptrdiff_t hint)
  {
    if (!(this->State.TolerancePerLine > 0.0f))
    {
      return true;
    }
    this->Test.Update(this->Best, static_cast<float>(Lines));
    return this->SegmentMayGain(hint);
  }

  HWY_INLINE void WalkSegment(std::ptrdiff_t segment)
  {
    const std::ptrdiff_t from = segment * Lines - this->Line;
    const Block raised = this->WalkLines(segment, from + 1, std::min(from + Lines, this->Last));
    if (AnyGreater(raised, this->Best))
    {
      this->Best = raised;
      this->Found.Add(static_cast<std::int32_t>(segment));
    }
  }

  HWY_INLINE bool SegmentMayGain(std::ptrdiff_t segment) const
  {
    const std::ptrdiff_t from = segment * Lines - this->Line;
    const std::ptrdiff_t at = this->Lane + this->State.EntryLane(from);
    return this->Test.MayGain(this->State.Bounds.Level(segment) + at,
      this->State.Bounds.Tilted(segment) + at, static_cast<float>(from), this->State.DropAt(from));
  }

  /// Bits of the groups begin .. end (at most 64) that may raise the horizon. There is one branch
  /// after all tests.
  HWY_INLINE Bits Groups(std::ptrdiff_t begin, std::ptrdiff_t end)
  {
    this->Test.Update(this->Best, static_cast<float>(Lines * PerGroup));
    Bits bits = 0;
    for (std::ptrdiff_t group = begin; group <= end; ++group)
    {
      const std::ptrdiff_t from = group * PerGroup * Lines - this->Line;
      if (from <= 0)
      {
        bits |= 1; // the receivers lie in this group, so its bounds from its near edge do not apply
        continue;
      }
      const std::ptrdiff_t at = this->Lane + this->State.EntryLane(from);
      const bool may = this->Test.MayGain(this->State.Bounds.GroupLevel(group) + at,
        this->State.Bounds.GroupTilted(group) + at, static_cast<float>(from),
        this->State.DropAt(from));
      bits |= static_cast<Bits>(may) << (group - begin);
    }
    return bits;
  }

  HWY_INLINE void SearchGroup(std::ptrdiff_t begin, std::ptrdiff_t end, const SegmentHints& walked)
  {
    this->Test.Update(this->Best, static_cast<float>(Lines));
    Bits segments = 0;
    for (std::ptrdiff_t segment = begin; segment <= end; ++segment)
    {
      segments |= static_cast<Bits>(this->SegmentMayGain(segment)) << (segment - begin);
    }
    // The bounds of a visited segment stay above its own horizon, so the test would select it
    // again.
    for (const std::int32_t hint : walked.Segments)
    {
      if (hint >= begin && hint <= end)
      {
        segments &= ~(Bits{ 1 } << (hint - begin));
      }
    }
    for (; segments != 0; segments &= segments - 1)
    {
      const std::ptrdiff_t segment = begin + LowestBit(segments);
      this->Test.Update(this->Best, static_cast<float>(Lines));
      if (this->SegmentMayGain(segment))
      {
        this->WalkSegment(segment);
      }
    }
  }

  const ExactState& State;
  const float* Origin;
  std::ptrdiff_t Line, Lane, Last;
  Block Heights;
  BlockTest Test;
  Block Best;
  SegmentHints Found;
};

template <Walk Kind, Body Shape, bool Holed>
void FindLanes(const ExactState& state, const FindTask& task)
{
  const std::ptrdiff_t width = BlockWidth();
  const RayFrame& frame = *state.Frame;
  // Block by block, and within a block in the direction against the rays. The posts ahead then stay
  // in the first-level cache, and the segments that raised the horizon of one line usually raise
  // that of the next.
  for (std::ptrdiff_t lane = task.LaneBegin; lane < task.LaneEnd; lane += width)
  {
    const std::ptrdiff_t leaves = frame.LastStep(lane, width);
    SegmentHints hints;
    for (std::ptrdiff_t line = task.LineEnd - 1; line >= task.LineBegin; --line)
    {
      const Block heights = Load(task.Receivers[line - task.LineBegin] + lane);
      BlockSearch<Kind, Shape, Holed> search(
        state, line, lane, std::min(frame.Lines - 1 - line, leaves), heights);
      const Block best = search.Run(hints);
      StoreSlopes(best, state.LinesPerMetre,
        task.Slopes + (line - task.LineBegin) * task.Stride + (lane - task.LaneBegin));
    }
  }
}

template <Walk Kind>
void FindTriangles(const ExactState& state, const FindTask& task)
{
  const bool holed = !state.Holes.Empty();
  if (state.Frame->DropPerLine2 == 0.0f)
  {
    holed ? FindLanes<Kind, Body::Flat, true>(state, task)
          : FindLanes<Kind, Body::Flat, false>(state, task);
  }
  else
  {
    holed ? FindLanes<Kind, Body::Curved, true>(state, task)
          : FindLanes<Kind, Body::Curved, false>(state, task);
  }
}

void FindAlong(const ExactState& state, const FindTask& task)
{
  FindTriangles<Walk::Along>(state, task);
}
void FindAgainst(const ExactState& state, const FindTask& task)
{
  FindTriangles<Walk::Against>(state, task);
}
void FindBilinear(const ExactState& state, const FindTask& task)
{
  FindLanes<Walk::Bilinear, Body::Curved, false>(state, task);
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
HWY_EXPORT(FindBilinear);

HorizonExact::HorizonExact(const HeightField& field, const HorizonSettings& settings)
  : Field(field)
  , Settings(settings)
{
}

void HorizonExact::SetAzimuth(const Grid& grid, double azimuth)
{
  this->Ray = std::make_unique<RayFrame>(this->Field, grid, azimuth, this->Settings.CurvatureDrop);
  const bool corners =
    this->Ray->Against || this->Field.HasMissing() || this->Settings.Shape == Surface::Bilinear;
  // One extreme post does not cost the others their digits, so it must not increase their rounding
  // error.
  const float largest = std::min(this->Field.LargestHeight(), static_cast<float>(PlainRelief));
  this->State.Set(*this->Ray, corners, this->Settings.Tolerance, largest);
  this->State.Holes.Resize(this->Field.MissingPosts(this->Ray->Columns));
}

void HorizonExact::SetReceivers(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd,
  std::ptrdiff_t laneBegin, std::ptrdiff_t laneEnd)
{
  this->State.LineBegin = lineBegin;
  this->State.LineEnd = lineEnd;
  this->State.LaneBegin = laneBegin;
  this->State.LaneEnd = laneEnd;
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
    this->State.Holes.Build(*this->Ray, this->Field.MissingPosts(this->Ray->Columns), group);
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
