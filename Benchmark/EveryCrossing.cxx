// SPDX-License-Identifier: BSD-3-Clause
#include "EveryCrossing.h"

#include <algorithm>
#include <vector>

// The plain loops are compiled once for each vector width, and the version is selected when the
// program starts, so that they use the same registers as the method that they are compared with.
// The selection happens before the address sanitizer is ready for it.
#if defined(__has_feature)
#define SKYLINE_HAS_FEATURE(name) __has_feature(name)
#else
#define SKYLINE_HAS_FEATURE(name) 0
#endif
#if defined(__x86_64__) && __has_attribute(target_clones) && !defined(__SANITIZE_ADDRESS__) &&     \
  !SKYLINE_HAS_FEATURE(address_sanitizer)
#define SKYLINE_EVERY_VECTOR                                                                       \
  __attribute__((target_clones("default", "arch=haswell", "arch=skylake-avx512")))
#else
#define SKYLINE_EVERY_VECTOR
#endif
// Of the memory that a loop uses, only the slopes are written.
#if defined(__clang__)
#define SKYLINE_NO_ALIAS _Pragma("clang loop vectorize(assume_safety)")
#else
#define SKYLINE_NO_ALIAS _Pragma("GCC ivdep")
#endif
#define SKYLINE_INLINE inline __attribute__((always_inline))

namespace skyline
{
namespace benchmark
{

namespace
{

// The posts that the rays of the lanes meet in one step: on the previous line and on the line
// itself, with neighbours on either side.
struct Posts
{
  const float *NearTrail, *NearLead, *NearBeyond; // beyond: on the far side of the lead
  const float *FarBehind, *FarTrail, *FarLead;    // behind: on the far side of the trail
};

struct Receivers
{
  const float* Heights;
  float* Best; // greatest slopes, in metres per line
  std::ptrdiff_t Begin, End;
};

// Two posts of an edge, with their weights.
struct Edge
{
  const float *A, *B;
  float WeightA, WeightB, Drop;

  SKYLINE_INLINE float Slope(std::ptrdiff_t lane, float height) const
  {
    return this->WeightA * (this->A[lane] - height) + this->WeightB * (this->B[lane] - height) -
      this->Drop;
  }
};

SKYLINE_INLINE float Larger(float a, float b)
{
  return a > b ? a : b;
}

SKYLINE_INLINE float Smaller(float a, float b)
{
  return a < b ? a : b;
}

// Raises the slope of each lane to those of two edges.
SKYLINE_INLINE void Raise(const Receivers& r, const Edge& first, const Edge& second)
{
  const float* heights = r.Heights;
  float* best = r.Best;
  SKYLINE_NO_ALIAS
  for (std::ptrdiff_t lane = r.Begin; lane < r.End; ++lane)
  {
    const float h = heights[lane];
    best[lane] = Larger(best[lane], Larger(first.Slope(lane, h), second.Slope(lane, h)));
  }
}

// The upper limit for slopes on the edges of a cell, which excludes them if one of the four posts
// is missing. It is a number and not a condition, because compilers do not vectorise loops with
// branches.
SKYLINE_INLINE float Limit(
  const float* a, const float* b, const float* c, const float* d, std::ptrdiff_t lane)
{
  const float low = Smaller(Smaller(a[lane], b[lane]), Smaller(c[lane], d[lane]));
  return low > 0.5f * MissingHeight ? -MissingHeight : MissingHeight;
}

// Raises the slopes, where an edge counts only if its cell is complete. For the edge between two
// cells, one complete cell is enough.
SKYLINE_INLINE void RaiseOneCell(
  const Receivers& r, const Posts& p, const Edge& entry, const Edge& middle, const Edge& row)
{
  const float* heights = r.Heights;
  float* best = r.Best;
  SKYLINE_NO_ALIAS
  for (std::ptrdiff_t lane = r.Begin; lane < r.End; ++lane)
  {
    const float h = heights[lane];
    const float limit = Limit(p.NearTrail, p.NearLead, p.FarTrail, p.FarLead, lane);
    const float slope =
      Larger(entry.Slope(lane, h), Larger(middle.Slope(lane, h), row.Slope(lane, h)));
    best[lane] = Larger(best[lane], Smaller(slope, limit));
  }
}

SKYLINE_INLINE void RaiseTwoCells(const Receivers& r, const Posts& p, const Edge& entry,
  const Edge& left, const Edge& middle, const Edge& right, const Edge& row)
{
  const float* heights = r.Heights;
  float* best = r.Best;
  SKYLINE_NO_ALIAS
  for (std::ptrdiff_t lane = r.Begin; lane < r.End; ++lane)
  {
    const float h = heights[lane];
    const float first = Limit(p.NearTrail, p.NearLead, p.FarBehind, p.FarTrail, lane);
    const float second = Limit(p.NearLead, p.NearBeyond, p.FarTrail, p.FarLead, lane);
    const float ofFirst = Larger(entry.Slope(lane, h), left.Slope(lane, h));
    const float ofSecond = Larger(right.Slope(lane, h), row.Slope(lane, h));
    const float ofBoth = Smaller(middle.Slope(lane, h), Larger(first, second));
    best[lane] = Larger(
      Larger(best[lane], ofBoth), Larger(Smaller(ofFirst, first), Smaller(ofSecond, second)));
  }
}

// The horizons of the lanes of one line.
SKYLINE_INLINE void CrossLine(const RayFrame& frame, std::ptrdiff_t line, const float* heights,
  float* best, std::ptrdiff_t laneBegin, std::ptrdiff_t laneEnd, bool holes)
{
  std::fill(best + laneBegin, best + laneEnd, MissingHeight);
  const std::ptrdiff_t drift = frame.Drift;
  for (std::ptrdiff_t d = 1; d < frame.Lines - line; ++d)
  {
    const RayStep& step = frame.Steps[static_cast<std::size_t>(d)];
    const RayStep& before = frame.Steps[static_cast<std::size_t>(d - 1)];
    const SideStep& side = frame.Sides[static_cast<std::size_t>(d)];
    const float* near = frame.Heights + (line + d - 1) * frame.LineStride + before.Lane;
    const float* far = frame.Heights + (line + d) * frame.LineStride + step.Lane;
    const Posts p{ near, near + drift, near + 2 * drift, far - drift, far, far + drift };
    // Rays that have left the data are not followed.
    const Receivers r{ heights, best, std::max<std::ptrdiff_t>(laneBegin, -step.Lane - 2),
      std::min<std::ptrdiff_t>(laneEnd, frame.Lanes - step.Lane + 2) };

    const bool next = step.Next != 0;
    const bool fromLead = next || frame.Against;
    const Edge row{ p.FarTrail, p.FarLead, step.RowTrail, step.RowLead, step.RowDrop };
    const Edge middle{ fromLead ? p.NearLead : p.NearTrail, fromLead ? p.FarTrail : p.FarLead,
      step.MidNear, step.MidFar, step.MidDrop };
    const bool sides = next && frame.Against;
    const Edge left =
      sides ? Edge{ p.NearLead, p.FarBehind, side.LeftNear, side.LeftFar, side.LeftDrop } : middle;
    const Edge right =
      sides ? Edge{ p.NearBeyond, p.FarTrail, side.RightNear, side.RightFar, side.RightDrop } : row;
    if (!holes)
    {
      Raise(r, row, middle);
      if (sides)
      {
        Raise(r, left, right);
      }
      continue;
    }
    const Edge entry = d > 1
      ? Edge{ p.NearTrail, p.NearLead, before.RowTrail, before.RowLead, before.RowDrop }
      : middle;
    if (next)
    {
      RaiseTwoCells(r, p, entry, left, middle, right, row);
    }
    else
    {
      RaiseOneCell(r, p, entry, middle, row);
    }
    if (frame.Places[static_cast<std::size_t>(d)].Part == 0.0)
    {
      // A ray through a post meets the cells around it. Posts that belong to no cell are missing in
      // the plane.
      const Edge post{ p.FarTrail, p.FarTrail, step.RowTrail, 0.0f, step.RowDrop };
      Raise(r, post, post);
    }
  }
}

SKYLINE_EVERY_VECTOR void CrossPlain(const RayFrame& frame, std::ptrdiff_t line,
  const float* heights, float* best, std::ptrdiff_t laneBegin, std::ptrdiff_t laneEnd)
{
  CrossLine(frame, line, heights, best, laneBegin, laneEnd, false);
}

SKYLINE_EVERY_VECTOR void CrossHoles(const RayFrame& frame, std::ptrdiff_t line,
  const float* heights, float* best, std::ptrdiff_t laneBegin, std::ptrdiff_t laneEnd)
{
  CrossLine(frame, line, heights, best, laneBegin, laneEnd, true);
}

} // namespace

EveryCrossing::EveryCrossing(const HeightField& field, const HorizonSettings& settings)
  : Field(field)
  , Settings(settings)
{
}

void EveryCrossing::SetAzimuth(const Grid& grid, double azimuth)
{
  this->Ray = std::make_unique<RayFrame>(this->Field, grid, azimuth, this->Settings.CurvatureDrop);
}

void EveryCrossing::Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
  std::ptrdiff_t laneEnd, float* slopes, std::ptrdiff_t stride) const
{
  const RayFrame& frame = *this->Ray;
  constexpr float noEdge = -1.0e14f; // metres per line, below any terrain
  std::vector<float> buffer;
  for (std::ptrdiff_t line = lineBegin; line < lineEnd; ++line)
  {
    const float* heights = this->Field.Receivers(frame.Columns, frame.ImageLine(line), buffer);
    float* best = slopes + (line - lineBegin) * stride - laneBegin;
    (this->Field.HasMissing() ? CrossHoles : CrossPlain)(
      frame, line, heights, best, laneBegin, laneEnd);
    const auto linesPerMetre = static_cast<float>(1.0 / frame.StepLength);
    for (std::ptrdiff_t lane = laneBegin; lane < laneEnd; ++lane)
    {
      best[lane] = best[lane] < noEdge ? NoTerrainSlope : best[lane] * linesPerMetre;
    }
  }
}

} // namespace benchmark
} // namespace skyline
