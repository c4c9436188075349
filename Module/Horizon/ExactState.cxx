// SPDX-License-Identifier: BSD-3-Clause
#include "Horizon/HorizonExact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyline
{

namespace
{
// Slope of the tilted support: T of SegmentBounds.
constexpr double SupportSlope = 0.15;

// Bounds that exceed a horizon by less than this part of the relief are only a rounding error of
// the float heights: 4 units in the last place. Without this, planes and lakes would be searched in
// full.
constexpr float RoundingPart = 4.0f * std::numeric_limits<float>::epsilon();

} // namespace

void SegmentBounds::Resize(std::ptrdiff_t lines, std::ptrdiff_t stride, std::ptrdiff_t margin)
{
  this->Segments = (lines - 1 + Lines - 1) / Lines;
  this->Groups = (this->Segments + PerGroup - 1) / PerGroup;
  this->Stride = stride;
  this->Margin = margin;
  const auto size = static_cast<std::size_t>(2 * (this->Segments + this->Groups) * stride);
  if (this->Values.size() != size)
  {
    this->Values.assign(size, MissingHeight);
  }
}

void GapsInSegments::Resize(const MissingMap& posts)
{
  this->Runs = posts.Runs;
  const std::ptrdiff_t segments = posts.Lines / SegmentBounds::Lines + 1;
  this->Missing.assign(static_cast<std::size_t>(segments * posts.Runs), 0);
}

void GapsInSegments::Build(const RayFrame& frame, const MissingMap& posts, std::ptrdiff_t group)
{
  constexpr std::ptrdiff_t lines = SegmentBounds::Lines;
  const std::ptrdiff_t begin = group * SegmentBounds::PerGroup;
  const std::ptrdiff_t end = std::min(begin + SegmentBounds::PerGroup, posts.Lines / lines + 1);
  for (std::ptrdiff_t segment = this->Empty() ? end : begin; segment < end; ++segment)
  {
    std::uint8_t* runs = this->Missing.data() + segment * this->Runs;
    const std::ptrdiff_t last = std::min((segment + 1) * lines, posts.Lines - 1);
    for (std::ptrdiff_t line = std::max<std::ptrdiff_t>(segment * lines - 1, 0); line <= last;
         ++line)
    {
      const std::uint8_t* missing = posts.Line(frame.ImageLine(line));
      for (std::ptrdiff_t run = 0; run < this->Runs; ++run)
      {
        runs[run] |= missing[run];
      }
    }
  }
}

void ExactState::Set(const RayFrame& frame, bool corners, double tolerance, float largestHeight)
{
  this->Frame = &frame;
  this->LineBegin = this->LaneBegin = 0;
  this->LineEnd = frame.Lines;
  this->LaneEnd = frame.Lanes;
  constexpr std::ptrdiff_t margin = 96; // the margin of the bounds, and a vector that is read
                                        // beyond it
  this->Bounds.Resize(frame.Lines, ((frame.Lanes + 2 * margin + 15) / 16 | 1) * 16, margin);
  this->Support = static_cast<float>(SupportSlope * frame.StepLength);
  this->SupportInverse = 1.0f / this->Support;
  this->TolerancePerLine = static_cast<float>(tolerance * frame.StepLength);
  this->Rounding = RoundingPart * largestHeight;
  this->LinesPerMetre = static_cast<float>(1.0 / frame.StepLength);

  const auto whole = [&](std::ptrdiff_t e) { return frame.DriftAfter(e); };
  const auto further = [&](std::ptrdiff_t e)
  { return static_cast<std::ptrdiff_t>(std::ceil(frame.Slant * static_cast<double>(e))); };
  for (std::ptrdiff_t e = 0; e <= SegmentBounds::Lines; ++e)
  {
    // A ray that enters at lane q in [0, 1) has its trail post at lane whole(e) or further(e), and
    // its lead post one lane further.
    std::ptrdiff_t first = whole(e);
    std::ptrdiff_t last = further(e) + 1;
    if (corners)
    {
      // Where a ray crosses from one column of cells to the next, the outer corners of both cells
      // count too.
      first -= e > 0 && whole(e) > whole(e - 1) ? 1 : 0;
      last += e < SegmentBounds::Lines && further(e + 1) > further(e) ? 1 : 0;
    }
    this->Reach[static_cast<std::size_t>(e)] =
      frame.Drift > 0 ? SegmentReach{ first, last } : SegmentReach{ 1 - last, 1 - first };
  }
}

ExactState::LaneRange ExactState::LanesAt(std::ptrdiff_t near, std::ptrdiff_t lines) const
{
  const std::ptrdiff_t first = -BoundMargin;
  const std::ptrdiff_t last = this->Frame->Lanes + BoundMargin;
  if (this->LaneBegin <= 0 && this->LaneEnd >= this->Frame->Lanes && this->LineBegin == 0)
  {
    return { first, last };
  }
  if (near + lines <= this->LineBegin)
  {
    return { first, first };
  }
  // The drift is least for a receiver on the last line before the edge, and greatest for one on the
  // first line. Blocks reach beyond the last receiver, and a group reads its segments one lane
  // aside.
  constexpr std::ptrdiff_t aside = 4, block = 64 + aside;
  const std::ptrdiff_t least =
    this->Frame->DriftAfter(std::max<std::ptrdiff_t>(0, near - (this->LineEnd - 1)));
  const std::ptrdiff_t most =
    this->Frame->DriftAfter(std::max<std::ptrdiff_t>(0, near - this->LineBegin));
  const bool up = this->Frame->Drift > 0;
  return { std::clamp(this->LaneBegin + (up ? least : -most) - aside, first, last),
    std::clamp(this->LaneEnd + (up ? most : -least) + block, first, last) };
}

} // namespace skyline
