// SPDX-License-Identifier: BSD-3-Clause
// The shadow height map of Lee & Kim, section 3.1, as published.
#ifndef skyline_ShadowHeightSweep_h
#define skyline_ShadowHeightSweep_h

#include "Horizon/HorizonMethod.h"
#include "SkylineCoreModule.h" // for the export macro

#include <vector>

namespace skyline
{

/// One pass over the posts, away from the light. The shadow height of a post is that of its
/// neighbours towards the light, minus the fall of the light: type 1 (equation 1) takes one
/// neighbour along an axis, type 2 interpolates between two neighbours for all other directions, in
/// all octants. Lines run along the axis that the light crosses more slowly. Each interpolation of
/// type 2 spreads an edge by about a post, so that the result is off by metres behind sharp edges.
/// Type 1 is exact at the posts. As published, the first line and lane are lit, the body is flat,
/// and a missing post passes on what it receives.
///
/// Used like ShadowHeightExact. Find writes the height that reaches the post from its neighbours,
/// before the maximum with the height of the post; NoShadow on the first line and lane.
class SKYLINECORE_EXPORT ShadowHeightSweep : public HorizonMethod
{
public:
  /// slope: the ShadowSlope of the light. The field must be closed and must outlive this object.
  ShadowHeightSweep(const HeightField& field, double slope);

  void SetAzimuth(const Grid& grid, double azimuth) override;
  /// 1: each line depends on the previous one.
  std::ptrdiff_t PrepareCount() const override { return 1; }
  void Prepare(std::ptrdiff_t begin, std::ptrdiff_t end) override;
  void Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd, float* heights, std::ptrdiff_t stride) const override;

protected:
  double Slope;
  std::vector<float> Cast; // [frame line][lane], filled by Prepare or by another processor

private:
  const HeightField& Field;
};

} // namespace skyline

#endif
