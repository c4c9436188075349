// SPDX-License-Identifier: BSD-3-Clause
// The rays for one azimuth on a distorted map, where the azimuth has another direction at each
// post.
#ifndef skyline_RayFan_h
#define skyline_RayFan_h

#include "Geo/GroundMetric.h"
#include "Shared/Constants.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <vector>

namespace skyline
{

/// Radians between neighbouring rays of a fan, measured on the ground of each post that uses them:
/// no ray used for a post departs further from its azimuth. The horizon is interpolated between two
/// rays, so that their mean direction is exact and no boundary is visible. 0.03 degrees.
constexpr double FanAzimuthStep = 0.03 * RadiansPerDegree;

/// Relative difference between the lengths of neighbouring rays. Slopes are scaled to the exact
/// length at each post. Only the effect of curvature, d (1 - k) / 2R, comes from the rays and is
/// interpolated.
constexpr double FanLengthStep = 0.02;

/// Directions and lengths that together serve all posts in one azimuth. The search with direction i
/// and length j uses the metric of the centre of the field with its lengths times exp(Lengths[j]),
/// and the azimuth Directions[i] on that metric.
class SKYLINECORE_EXPORT RayFan
{
public:
  /// azimuth: radians from the +y axis of the image, on the image (`onImage`) or on the ground.
  /// curved: true if the body is curved; otherwise one length serves all posts.
  RayFan(const GroundMetric& metric, double azimuth, bool onImage, bool curved);

  std::vector<double> Directions, Lengths; ///< rising, at least one each; directions in radians

  bool IsOne() const { return this->Directions.size() * this->Lengths.size() == 1; }

  /// The metric of the searches with length j.
  PostMetric MetricOf(std::size_t length) const;

  /// Fractional indices of the posts (column .. column + count - 1, row) among the directions and
  /// the lengths: 1.25 is a quarter of the way from the second to the third.
  void Places(std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, float* directions,
    float* lengths) const;

private:
  const GroundMetric& Metric;
  PostMetric Reference;
  std::vector<float> Direction, Length; ///< of the nodes of the metric, as fractional indices
};

} // namespace skyline

#endif
