// SPDX-License-Identifier: BSD-3-Clause
// Shadow heights by the search of the exact horizon: with weights that sum to 1, and the fall of
// the light in place of the drop, the greatest slope becomes the greatest height.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ShadowHeight/ShadowHeight.cxx"
#include "hwy/foreach_target.h"

#include "Horizon/RayWalk-inl.h"
#include "ShadowHeight/ShadowHeight.h"

#include "hwy/highway.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace skyline
{
namespace HWY_NAMESPACE
{

// Searches for one block of receivers, given by its first lane and line.
template <Walk Kind>
class ShadowSearch
{
public:
  HWY_INLINE ShadowSearch(const ShadowHeightTask& task, std::ptrdiff_t line, std::ptrdiff_t lane)
    : Task(task)
    , Frame(task.Frame)
    , Line(line)
    , Lane(lane)
    , Best(Same(NoShadow))
  {
  }

  HWY_INLINE Block Run()
  {
    const std::ptrdiff_t last =
      std::min(this->Frame.LastStep(this->Lane, BlockWidth()), this->Frame.Lines - 1 - this->Line);
    std::ptrdiff_t coarseEnd = 0;
    for (std::ptrdiff_t first = 1; first <= last;)
    {
      this->LookFrom(first);
      if (!this->MayGain(this->Task.Tiles.Highest()))
      {
        break;
      }
      if (first > coarseEnd)
      {
        coarseEnd = this->TileEnd(first, ShadowHeightTiles::Coarse);
        const std::ptrdiff_t row = this->TileRow(first, ShadowHeightTiles::Coarse);
        const Reach reach = this->ReachOf(first, std::min(coarseEnd, last));
        if (!this->MayGain(this->Task.Tiles.CoarseTop(row, reach.First, reach.Last)))
        {
          first = coarseEnd + 1;
          continue;
        }
      }
      const std::ptrdiff_t end = std::min(this->TileEnd(first, ShadowHeightTiles::Fine), last);
      const std::ptrdiff_t row = this->TileRow(first, ShadowHeightTiles::Fine);
      const Reach reach = this->ReachOf(first, end);
      if (this->MayGain(this->Task.Tiles.FineTop(row, reach.First, reach.Last)))
      {
        const float* origin =
          this->Frame.Heights + this->Line * this->Frame.LineStride + this->Lane;
        this->Best =
          WalkSteps<Kind, Body::Curved>(this->Frame, origin, Same(0.0f), this->Best, first, end);
      }
      first = end + 1;
    }
    return this->Best;
  }

private:
  struct Reach
  {
    std::ptrdiff_t First, Last; // lanes of the plane
  };

  // Tiles are counted in lines of the image, steps in lines of the frame.
  HWY_INLINE std::ptrdiff_t TileRow(std::ptrdiff_t step, std::ptrdiff_t size) const
  {
    return this->Frame.ImageLine(this->Line + step) / size;
  }
  HWY_INLINE std::ptrdiff_t TileEnd(std::ptrdiff_t step, std::ptrdiff_t size) const
  {
    const std::ptrdiff_t row = this->TileRow(step, size);
    return this->Frame.ImageLine(this->Frame.Reversed ? row * size : row * size + size - 1) -
      this->Line;
  }

  // The lanes of the posts around the rays in steps first .. last, with two more lanes on each
  // side.
  HWY_INLINE Reach ReachOf(std::ptrdiff_t first, std::ptrdiff_t last) const
  {
    const std::ptrdiff_t near = this->Frame.DriftAfter(first - 1);
    const std::ptrdiff_t far = this->Frame.DriftAfter(last);
    const std::ptrdiff_t end = this->Lane + BlockWidth();
    return this->Frame.Drift > 0 ? Reach{ this->Lane + near - 2, end + far + 1 }
                                 : Reach{ this->Lane - far - 2, end - near + 1 };
  }

  // Sets the least fall of the rays from this step on, and which rays are still inside the data.
  HWY_INLINE void LookFrom(std::ptrdiff_t step)
  {
    const auto lines = static_cast<double>(step - 1);
    this->Fall =
      static_cast<float>(lines * (this->Task.FallPerLine + lines * this->Task.DropPerLine2));
    const std::ptrdiff_t drift = this->Frame.DriftAfter(step - 1);
    const bool right = this->Frame.Drift > 0;
    const std::ptrdiff_t begin = (right ? 0 : drift) - this->Lane;
    const std::ptrdiff_t end =
      std::min(this->Task.LaneEnd, this->Frame.Lanes - (right ? drift : 0)) - this->Lane;
    const Vector from = hn::Set(Lanes(), static_cast<float>(begin));
    const Vector to = hn::Set(Lanes(), static_cast<float>(end));
    const Vector first = hn::Iota(Lanes(), 0.0f);
    const Vector second = hn::Iota(Lanes(), static_cast<float>(VectorWidth()));
    this->Inside = { hn::And(hn::Ge(first, from), hn::Lt(first, to)),
      hn::And(hn::Ge(second, from), hn::Lt(second, to)) };
  }

  // Whether posts up to the height `top` may raise the shadow height of a receiver.
  HWY_INLINE bool MayGain(float top) const
  {
    const Vector reached = hn::Set(Lanes(), top - this->Fall);
    return !hn::AllFalse(Lanes(),
      hn::Or(hn::And(this->Inside.First, hn::Lt(this->Best.First, reached)),
        hn::And(this->Inside.Second, hn::Lt(this->Best.Second, reached))));
  }

  const ShadowHeightTask& Task;
  const RayFrame& Frame;
  std::ptrdiff_t Line, Lane;
  Block Best;
  BlockMask Inside{};
  float Fall = 0.0f;
};

template <Walk Kind>
HWY_INLINE void FindShadows(const ShadowHeightTask& task)
{
  const Vector limit = hn::Set(Lanes(), LeastShadowHeight);
  const Vector none = hn::Set(Lanes(), NoShadow);
  for (std::ptrdiff_t line = task.LineBegin; line < task.LineEnd; ++line)
  {
    float* out = task.Heights + (line - task.LineBegin) * task.Stride - task.LaneBegin;
    for (std::ptrdiff_t lane = task.LaneBegin; lane < task.LaneEnd; lane += BlockWidth())
    {
      const Block best = ShadowSearch<Kind>(task, line, lane).Run();
      Store(Each([&](Vector x) { return hn::IfThenElse(hn::Lt(x, limit), none, x); }, best),
        out + lane);
    }
  }
}

void FindShadowHeights(const ShadowHeightTask& task)
{
  if (task.Holes)
  {
    FindShadows<Walk::Holes>(task);
  }
  else if (task.Frame.Against)
  {
    FindShadows<Walk::Against>(task);
  }
  else
  {
    FindShadows<Walk::Along>(task);
  }
}

} // namespace HWY_NAMESPACE
} // namespace skyline
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace skyline
{

namespace
{

HWY_EXPORT(FindShadowHeights);

// Converts the slopes of the steps to heights. An edge at the fraction t between two posts, `line`
// lines from the receiver, has the weights 1 - t and t, and the light falls on its way.
class HeightSteps
{
public:
  HeightSteps(double fallPerLine, double dropPerLine2)
    : FallPerLine(fallPerLine)
    , DropPerLine2(dropPerLine2)
  {
  }

  void Set(double t, double line, float& near, float& far, float& fall) const
  {
    const bool receiver = !(line > 0.0); // which casts no shadow on itself
    near = receiver ? 0.0f : static_cast<float>(1.0 - t);
    far = receiver ? 0.0f : static_cast<float>(t);
    fall = receiver ? -MissingHeight
                    : static_cast<float>(line * (this->FallPerLine + line * this->DropPerLine2));
  }

  void Apply(RayFrame& frame) const
  {
    for (std::size_t d = 1; d < frame.Steps.size(); ++d)
    {
      const auto line = static_cast<double>(d);
      const double before = line - 1.0;
      const StepPlace& place = frame.Places[d];
      RayStep& step = frame.Steps[d];
      this->Set(place.Part, line, step.RowTrail, step.RowLead, step.RowDrop);
      this->Set(place.MidLine - before, place.MidLine, step.MidNear, step.MidFar, step.MidDrop);
      if (step.Next != 0)
      {
        SideStep& side = frame.Sides[d];
        const double part = frame.Places[d - 1].Part;
        const double left = (1.0 - part) / (1.0 + frame.Slant);
        const double right = (2.0 - part) / (1.0 + frame.Slant);
        this->Set(left, before + left, side.LeftNear, side.LeftFar, side.LeftDrop);
        this->Set(right, before + right, side.RightNear, side.RightFar, side.RightDrop);
      }
    }
  }

private:
  double FallPerLine, DropPerLine2;
};

} // namespace

double ShadowSlope(double elevation)
{
  return elevation > 0.0 ? std::tan(std::min(elevation, HighestShadowLight)) : 0.0;
}

ShadowHeightExact::ShadowHeightExact(const HeightField& field, double slope, double drop)
  : Field(field)
  , Slope(slope)
  , CurvatureDrop(drop)
{
}

void ShadowHeightExact::SetAzimuth(const Grid& grid, double azimuth)
{
  this->Ray = std::make_unique<RayFrame>(this->Field, grid, azimuth, this->CurvatureDrop);
  RayFrame& frame = *this->Ray;
  this->FallPerLine = this->Slope * frame.StepLength;
  HeightSteps(this->FallPerLine, this->CurvatureDrop * frame.StepLength * frame.StepLength)
    .Apply(frame);
  (frame.Columns ? this->ColumnTiles : this->RowTiles)
    .Build(frame.Columns ? this->Field.ColumnPlane() : this->Field.RowPlane());
}

void ShadowHeightExact::Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd,
  std::ptrdiff_t laneBegin, std::ptrdiff_t laneEnd, float* heights, std::ptrdiff_t stride) const
{
  const RayFrame& frame = *this->Ray;
  const ShadowHeightTask task{ frame, frame.Columns ? this->ColumnTiles : this->RowTiles,
    this->FallPerLine, this->CurvatureDrop * frame.StepLength * frame.StepLength,
    this->Field.HasMissing(), lineBegin, lineEnd, laneBegin, laneEnd, heights, stride };
  HWY_DYNAMIC_DISPATCH(FindShadowHeights)(task);
}

} // namespace skyline
#endif
