// SPDX-License-Identifier: BSD-3-Clause
// The shadow height map of Lee & Kim, section 3.1, as published.
#ifndef skyline_ShadowHeightSweep_h
#define skyline_ShadowHeightSweep_h

#include "Horizon/HorizonMethod.h"
#include "SkylineCoreModule.h" // for the export macro

#include <vector>

namespace skyline
{

/// One pass over the posts, away from the light: a post's shadow height is what its neighbours
/// towards the light hand on less the fall of the light, type 1 (equation 1) from one neighbour along
/// an axis, type 2 interpolated between two for any other direction, in all octants; lines run along
/// whichever axis the light crosses slower. The interpolation of type 2 spreads every edge by about a
/// post each time it hands it on, so it is off by metres behind sharp edges; type 1 is exact on the
/// posts. As published, the first line and lane are lit, the body is flat, and a missing post hands on
/// what it got.
///
/// Driven like ShadowHeightExact: Find gives what reaches the post from its neighbours, before the
/// maximum with the post's own height; NoShadow on the first line and lane.
class SKYLINECORE_EXPORT ShadowHeightSweep : public HorizonMethod
{
public:
  /// The light's ShadowSlope. The field is closed and outlives this.
  ShadowHeightSweep(const HeightField& field, double slope);

  void SetAzimuth(const Grid& grid, double azimuth) override;
  std::ptrdiff_t PrepareCount() const override { return 1; } // each line needs the one before
  void Prepare(std::ptrdiff_t begin, std::ptrdiff_t end) override;
  void Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd, float* heights, std::ptrdiff_t stride) const override;

protected:
  double Slope;
  std::vector<float> Cast; // [frame line][lane]: what Prepare fills, or another processor

private:
  const HeightField& Field;
};

} // namespace skyline

#endif
