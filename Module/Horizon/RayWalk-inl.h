// SPDX-License-Identifier: BSD-3-Clause
// The inner loop of the exact search: visits all edges that the rays of a vector of receivers meet,
// step by step. Highway's foreach_target includes this file once per processor target, so it has no
// include guard.
#if defined(skyline_RayWalk_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef skyline_RayWalk_inl_h
#undef skyline_RayWalk_inl_h
#else
#define skyline_RayWalk_inl_h
#endif

#include "Horizon/RayFrame.h"
#include "Shared/Constants.h"

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace skyline
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Up to 16 neighbouring receivers of a line: one AVX-512 register.
using Lanes = hn::CappedTag<float, 16>;
using Vector = hn::Vec<Lanes>;
using Mask = hn::Mask<Lanes>;

HWY_INLINE std::ptrdiff_t VectorWidth()
{
  return static_cast<std::ptrdiff_t>(hn::Lanes(Lanes()));
}

/// A block of receivers: two vectors, so that the processor can compute with one while the other
/// waits for its maximum. PaddedPlane::Margin covers a block and its reach.
struct Block
{
  Vector First, Second;
};
struct BlockMask
{
  Mask First, Second;
};

HWY_INLINE std::ptrdiff_t BlockWidth()
{
  return 2 * VectorWidth();
}

/// Applies f to the first vectors and to the second vectors.
template <typename Function, typename... Blocks>
HWY_INLINE Block Each(const Function& f, const Blocks&... blocks)
{
  return { f(blocks.First...), f(blocks.Second...) };
}

HWY_INLINE Block Same(float value)
{
  const Vector v = hn::Set(Lanes(), value);
  return { v, v };
}
HWY_INLINE Block Load(const float* from)
{
  return { hn::LoadU(Lanes(), from), hn::LoadU(Lanes(), from + VectorWidth()) };
}
HWY_INLINE void Store(const Block& block, float* to)
{
  hn::StoreU(block.First, Lanes(), to);
  hn::StoreU(block.Second, Lanes(), to + VectorWidth());
}
HWY_INLINE Block Sub(const Block& a, const Block& b)
{
  return { hn::Sub(a.First, b.First), hn::Sub(a.Second, b.Second) };
}
HWY_INLINE Block Max(const Block& a, const Block& b)
{
  return { hn::Max(a.First, b.First), hn::Max(a.Second, b.Second) };
}
HWY_INLINE bool AnyGreater(const Block& a, const Block& b)
{
  return !hn::AllFalse(Lanes(), hn::Or(hn::Gt(a.First, b.First), hn::Gt(a.Second, b.Second)));
}

/// The kind of surface between the posts.
enum class Walk
{
  Along,   ///< triangles without missing posts, diagonals along the drift
  Against, ///< triangles without missing posts, diagonals against the drift
  Holes,   ///< triangles; cells with a missing post carry no surface
  Bilinear ///< bilinear patches, with or without missing posts
};

/// Whether curvature lowers posts with their distance. Loads limit the speed of the search, and a
/// flat body needs two fewer per step.
enum class Body
{
  Flat,
  Curved
};

/// The slope at which the rays meet the edge between posts a and b.
template <Body Shape = Body::Curved>
HWY_INLINE Block Edge(float weightA, const Block& a, float weightB, const Block& b, float drop)
{
  const Vector wa = hn::Set(Lanes(), weightA);
  const Vector wb = hn::Set(Lanes(), weightB);
  if constexpr (Shape == Body::Flat)
  {
    return Each([&](Vector x, Vector y) { return hn::MulAdd(wb, y, hn::Mul(wa, x)); }, a, b);
  }
  const Vector s = hn::Set(Lanes(), drop);
  return Each([&](Vector x, Vector y) { return hn::MulAdd(wb, y, hn::MulSub(wa, x, s)); }, a, b);
}

/// `best`, raised to the slope of an edge if the cell is complete.
HWY_INLINE Block EdgeOf(const BlockMask& complete, const Block& best, float weightA, const Block& a,
  float weightB, const Block& b, float drop)
{
  const Block edge = Max(best, Edge(weightA, a, weightB, b, drop));
  return { hn::IfThenElse(complete.First, edge.First, best.First),
    hn::IfThenElse(complete.Second, edge.Second, best.Second) };
}

/// Cells with all four posts. Heights are relative to the receiver, so they are compared with half
/// of MissingHeight.
HWY_INLINE BlockMask Complete(const Block& a, const Block& b, const Block& c, const Block& d)
{
  const Vector limit = hn::Set(Lanes(), 0.5f * MissingHeight);
  return { hn::Gt(hn::Min(hn::Min(a.First, b.First), hn::Min(c.First, d.First)), limit),
    hn::Gt(hn::Min(hn::Min(a.Second, b.Second), hn::Min(c.Second, d.Second)), limit) };
}

/// The greatest slope inside a complete bilinear patch, between the entry of the ray at height `in`
/// (relative to the receiver), `lineIn` lines away, and its exit. With the curvature `bend` (metres
/// per line squared, including the drop of the body), the slope at T lines is  a / T + b + bend T.
/// Its maximum inside is at T^2 = a / bend if both are negative.
HWY_INLINE Vector InsidePatch(Mask complete, Vector best, const RayFrame& frame, Vector in,
  double lineIn, Vector out, double lineOut, Vector twist)
{
  if (!(lineOut > lineIn) || frame.Slant == 0.0)
  {
    return best; // the ray only touches this cell or follows its edge
  }
  const Lanes tag;
  const Vector t0 = hn::Set(tag, static_cast<float>(lineIn));
  const Vector t1 = hn::Set(tag, static_cast<float>(lineOut));
  const Vector drop = hn::Set(tag, frame.DropPerLine2);
  const Vector bend = hn::MulSub(hn::Set(tag, static_cast<float>(frame.Slant)), twist, drop);
  const Vector low = hn::NegMulAdd(drop, hn::Mul(t0, t0), in);
  const Vector high = hn::NegMulAdd(drop, hn::Mul(t1, t1), out);
  const Vector rise =
    hn::Mul(hn::Sub(high, low), hn::Set(tag, static_cast<float>(1.0 / (lineOut - lineIn))));
  if (lineIn == 0.0)
  {
    // In the patch that starts at the receiver, the slope at the receiver is the limit of that of
    // the ray.
    return hn::IfThenElse(complete, hn::Max(best, hn::NegMulAdd(bend, t1, rise)), best);
  }
  const Vector a = hn::MulAdd(bend, hn::Mul(t0, t1), hn::NegMulAdd(rise, t0, low));
  const auto peaked =
    hn::And(complete, hn::And(hn::Lt(bend, hn::Zero(tag)), hn::Lt(a, hn::Zero(tag))));
  // Computed from the entry, because b - 2 sqrt(a bend) loses digits far from the receiver. Without
  // a maximum, the divisor -1 avoids 0 / 0 in unused lanes. A maximum beyond the exit is taken at
  // the exit, which also avoids overflow with missing heights and a bend near 0.
  const Vector divisor = hn::IfThenElse(peaked, bend, hn::Set(tag, -1.0f));
  const Vector least = hn::Mul(divisor, hn::Mul(t1, t1));
  const Vector square = hn::Max(hn::Div(hn::Max(a, least), divisor), hn::Zero(tag));
  const Vector t = hn::Min(hn::Max(hn::Sqrt(square), t0), t1);
  const Vector height = hn::MulAdd(hn::Sub(t, t0), hn::MulAdd(bend, hn::Sub(t, t1), rise), low);
  return hn::IfThenElse(peaked, hn::Max(best, hn::Div(height, t)), best);
}

HWY_INLINE Block InsidePatch(const BlockMask& complete, const Block& best, const RayFrame& frame,
  const Block& in, double lineIn, const Block& out, double lineOut, const Block& twist)
{
  return { InsidePatch(
             complete.First, best.First, frame, in.First, lineIn, out.First, lineOut, twist.First),
    InsidePatch(
      complete.Second, best.Second, frame, in.Second, lineIn, out.Second, lineOut, twist.Second) };
}

/// The heights on the edges from a to b, at the fraction `part` of the way.
HWY_INLINE Block Mix(const Block& a, const Block& b, double part)
{
  const Vector p = hn::Set(Lanes(), static_cast<float>(part));
  return Each([&](Vector x, Vector y) { return hn::MulAdd(p, hn::Sub(y, x), x); }, a, b);
}

/// Raises `best` (metres per line) to the greatest slope that the rays meet in steps first .. last.
/// origin: post of the first receiver; heights: those of the receivers.
template <Walk Kind, Body Shape>
HWY_INLINE Block WalkSteps(const RayFrame& frame, const float* HWY_RESTRICT origin,
  const Block& heights, Block best, std::ptrdiff_t first, std::ptrdiff_t last)
{
  const std::ptrdiff_t drift = frame.Drift;
  const RayStep* HWY_RESTRICT steps = frame.Steps.data();
  const SideStep* HWY_RESTRICT sides = frame.Sides.data();
  const StepPlace* HWY_RESTRICT places = frame.Places.data();
  const float* before = origin + (first - 1) * frame.LineStride + steps[first - 1].Lane;
  Block trailBefore = Sub(Load(before), heights);
  Block leadBefore = Sub(Load(before + drift), heights);
  const float* line = origin + first * frame.LineStride;
  if (Kind == Walk::Along && first == 1)
  {
    // The diagonal of the first step starts at the receiver and is not part of the horizon.
    const RayStep& step = steps[1];
    before = line + step.Lane;
    trailBefore = Sub(Load(before), heights);
    leadBefore = Sub(Load(before + drift), heights);
    best =
      Max(best, Edge<Shape>(step.RowTrail, trailBefore, step.RowLead, leadBefore, step.RowDrop));
    line += frame.LineStride;
    ++first;
  }
  for (std::ptrdiff_t d = first; d <= last; ++d, line += frame.LineStride)
  {
    const RayStep& step = steps[d];
    const float* post = line + step.Lane;
    const Block trail = Sub(Load(post), heights);
    const Block lead = Sub(Load(post + drift), heights);
    // The edges of a step are combined first, so that only one maximum depends on the previous
    // step.
    if constexpr (Kind == Walk::Along)
    {
      const Block row = Edge<Shape>(step.RowTrail, trail, step.RowLead, lead, step.RowDrop);
      const Block middle = step.Next != 0
        ? Edge<Shape>(step.MidNear, leadBefore, step.MidFar, trail, step.MidDrop)
        : Edge<Shape>(step.MidNear, trailBefore, step.MidFar, lead, step.MidDrop);
      best = Max(best, Max(row, middle));
    }
    else if constexpr (Kind == Walk::Against)
    {
      const Block row = Edge<Shape>(step.RowTrail, trail, step.RowLead, lead, step.RowDrop);
      const Block middle = Edge<Shape>(step.MidNear, leadBefore, step.MidFar, trail, step.MidDrop);
      best = Max(best, Max(row, middle));
      if (step.Next != 0)
      {
        const SideStep& side = sides[d];
        const Block left = Sub(Load(post - drift), heights);
        const Block right = Sub(Load(before + 2 * drift), heights);
        best = Max(best,
          Max(Edge<Shape>(side.LeftNear, leadBefore, side.LeftFar, left, side.LeftDrop),
            Edge<Shape>(side.RightNear, right, side.RightFar, trail, side.RightDrop)));
      }
    }
    else
    {
      // Cell by cell: an edge between two cells is visited from both, and counts if either cell is
      // complete.
      const RayStep& entry = steps[d - 1];
      const bool mixed = Kind == Walk::Bilinear;
      if (step.Next == 0)
      {
        const auto complete = Complete(trailBefore, leadBefore, trail, lead);
        if (d > 1)
        {
          best = EdgeOf(
            complete, best, entry.RowTrail, trailBefore, entry.RowLead, leadBefore, entry.RowDrop);
        }
        best = EdgeOf(complete, best, step.RowTrail, trail, step.RowLead, lead, step.RowDrop);
        if (mixed)
        {
          const Block twist = Sub(Sub(lead, trail), Sub(leadBefore, trailBefore));
          best = InsidePatch(complete, best, frame,
            Mix(trailBefore, leadBefore, places[d - 1].Part), static_cast<double>(d) - 1.0,
            Mix(trail, lead, places[d].Part), static_cast<double>(d), twist);
        }
        else
        {
          best = EdgeOf(complete, best, step.MidNear, frame.Against ? leadBefore : trailBefore,
            step.MidFar, frame.Against ? trail : lead, step.MidDrop);
        }
      }
      else
      {
        const SideStep& side = sides[d];
        const Block left = Sub(Load(post - drift), heights);
        const Block right = Sub(Load(before + 2 * drift), heights);
        const auto leftComplete = Complete(trailBefore, leadBefore, left, trail);
        const auto rightComplete = Complete(leadBefore, right, trail, lead);
        if (d > 1)
        {
          best = EdgeOf(leftComplete, best, entry.RowTrail, trailBefore, entry.RowLead, leadBefore,
            entry.RowDrop);
        }
        best = EdgeOf({ hn::Or(leftComplete.First, rightComplete.First),
                        hn::Or(leftComplete.Second, rightComplete.Second) },
          best, step.MidNear, leadBefore, step.MidFar, trail, step.MidDrop);
        best = EdgeOf(rightComplete, best, step.RowTrail, trail, step.RowLead, lead, step.RowDrop);
        if (mixed)
        {
          const Block middle =
            Mix(leadBefore, trail, places[d].MidLine - (static_cast<double>(d) - 1.0));
          best = InsidePatch(leftComplete, best, frame,
            Mix(trailBefore, leadBefore, places[d - 1].Part), static_cast<double>(d) - 1.0, middle,
            places[d].MidLine, Sub(Sub(trail, left), Sub(leadBefore, trailBefore)));
          best = InsidePatch(rightComplete, best, frame, middle, places[d].MidLine,
            Mix(trail, lead, places[d].Part), static_cast<double>(d),
            Sub(Sub(lead, trail), Sub(right, leadBefore)));
        }
        else if (frame.Against)
        {
          best = EdgeOf(
            leftComplete, best, side.LeftNear, leadBefore, side.LeftFar, left, side.LeftDrop);
          best = EdgeOf(
            rightComplete, best, side.RightNear, right, side.RightFar, trail, side.RightDrop);
        }
      }
      if (places[d].Part == 0.0)
      {
        // A post that occludes has a complete cell beside it.
        best = Max(best, Edge(step.RowTrail, trail, 0.0f, trail, step.RowDrop));
      }
    }
    before = post;
    trailBefore = trail;
    leadBefore = lead;
  }
  return best;
}

/// A limit in metres per line: all slopes of terrain lie above it, and all edges with a missing
/// post below.
constexpr float NoEdge = -1.0e14f;

/// Converts slopes per line to slopes and stores them.
HWY_INLINE void StoreSlopes(const Block& best, float linesPerMetre, float* slopes)
{
  const Vector scale = hn::Set(Lanes(), linesPerMetre);
  const Vector none = hn::Set(Lanes(), NoTerrainSlope);
  const Vector limit = hn::Set(Lanes(), NoEdge);
  Store(Each(
          [&](Vector x)
          {
            // Avoids overflow of missing posts with spacings of micrometres, in lanes that are not
            // used.
            return hn::IfThenElse(hn::Lt(x, limit), none, hn::Mul(hn::Max(x, limit), scale));
          },
          best),
    slopes);
}

} // namespace HWY_NAMESPACE
} // namespace skyline
HWY_AFTER_NAMESPACE();

#endif
