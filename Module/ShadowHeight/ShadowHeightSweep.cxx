// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowHeight/ShadowHeightSweep.h"

#include "ShadowHeight/ShadowHeight.h"

#include <algorithm>

namespace skyline
{

ShadowHeightSweep::ShadowHeightSweep(const HeightField& field, double slope)
  : Slope(slope)
  , Field(field)
{
}

void ShadowHeightSweep::SetAzimuth(const Grid& grid, double azimuth)
{
  this->Ray = std::make_unique<RayFrame>(this->Field, grid, azimuth, 0.0);
  this->Cast.resize(static_cast<std::size_t>(this->Ray->Lines * this->Ray->Lanes));
}

void ShadowHeightSweep::Prepare(std::ptrdiff_t begin, std::ptrdiff_t end)
{
  if (begin >= end)
  {
    return;
  }
  const RayFrame& frame = *this->Ray;
  const std::ptrdiff_t lanes = frame.Lanes;
  const auto aside = static_cast<float>(frame.Slant); // x_off of the paper
  const float straight = 1.0f - aside;
  const auto fall = static_cast<float>(this->Slope * frame.StepLength); // s k of the paper
  // Shadow heights of the previous line, with one more lane on each side for the neighbour beside
  // it.
  std::vector<float> shadow(static_cast<std::size_t>(lanes + 2), MissingHeight);
  std::vector<float> next(shadow);
  std::fill_n(this->Cast.data() + (frame.Lines - 1) * lanes, lanes, NoShadow);
  std::copy_n(frame.Heights + (frame.Lines - 1) * frame.LineStride, lanes, shadow.begin() + 1);
  for (std::ptrdiff_t line = frame.Lines - 2; line >= 0; --line)
  {
    const float* heights = frame.Heights + line * frame.LineStride;
    const float* ahead = shadow.data() + 1;
    const float* neighbour = ahead + frame.Drift;
    float* cast = this->Cast.data() + line * lanes;
    float* result = next.data() + 1;
    for (std::ptrdiff_t lane = 0; lane < lanes; ++lane)
    {
      cast[lane] = straight * ahead[lane] + aside * neighbour[lane] - fall;
      result[lane] = std::max(heights[lane], cast[lane]);
    }
    if (aside > 0.0f) // the first lane has no neighbour on that side
    {
      const std::ptrdiff_t first = frame.Drift > 0 ? lanes - 1 : 0;
      cast[first] = NoShadow;
      result[first] = heights[first];
    }
    shadow.swap(next);
  }
}

void ShadowHeightSweep::Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd,
  std::ptrdiff_t laneBegin, std::ptrdiff_t laneEnd, float* heights, std::ptrdiff_t stride) const
{
  for (std::ptrdiff_t line = lineBegin; line < lineEnd; ++line)
  {
    const float* cast = this->Cast.data() + line * this->Ray->Lanes;
    float* out = heights + (line - lineBegin) * stride - laneBegin;
    for (std::ptrdiff_t lane = laneBegin; lane < laneEnd; ++lane)
    {
      out[lane] = cast[lane] > LeastShadowHeight ? cast[lane] : NoShadow;
    }
  }
}

} // namespace skyline
