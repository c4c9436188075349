// SPDX-License-Identifier: BSD-3-Clause
// Passes the horizons of one post to accumulators.
#ifndef skyline_KernelTesting_h
#define skyline_KernelTesting_h

#include "Reference/Oracle.h"
#include "Sky/SkyAccumulator.h"

#include <cstddef>
#include <vector>

namespace skyline
{
namespace testing
{

/// The error of a sum of a hundred floats up to 1, and of the arc, 1.4e-7 rad.
constexpr double SumBound = 2.0e-6;

/// The same in degrees of openness: floats near 100 are 8e-6 apart.
constexpr double OpennessBound = 1.0e-4;

/// All quantities of one post with a gradient, from slopes in the azimuths (k + shift) 2 pi / N.
inline oracle::Sky SumSky(
  const std::vector<double>& slopes, double east, double north, double shift = 0.0)
{
  float sums[5] = {};
  SkyBuffers buffers;
  buffers.SkyViewFactor.Values = &sums[0];
  buffers.SkyViewFactorHorizontal.Values = &sums[1];
  buffers.VisibleSkyFraction.Values = &sums[2];
  buffers.PositiveOpenness.Values = &sums[3];
  buffers.UniformAmbient.Values = &sums[4];
  const auto floatEast = static_cast<float>(east), floatNorth = static_cast<float>(north);
  SkyAccumulator sky(1, buffers, &floatEast, &floatNorth);
  const double width = 2.0 * Pi / static_cast<double>(slopes.size());
  for (std::size_t k = 0; k < slopes.size(); ++k)
  {
    const auto slope = static_cast<float>(slopes[k]);
    sky.Begin((static_cast<double>(k) + shift) * width, width);
    sky.Add(0, 0, 1, &slope);
  }
  sky.Finish(0, 1);
  return { sums[0], sums[1], sums[2], sums[3], sums[4] };
}

} // namespace testing
} // namespace skyline

#endif
