// SPDX-License-Identifier: BSD-3-Clause
// The rays that one azimuth needs on a distorted map, where it runs in another direction at every post.
#ifndef skyline_RayFan_h
#define skyline_RayFan_h

#include "Geo/GroundMetric.h"
#include "Shared/Constants.h"
#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <vector>

namespace skyline
{

/// Radians between neighbouring rays of a fan, on the ground of every post that uses them: no ray that
/// counts for a post leaves it further beside its azimuth. The horizon is interpolated between both, so
/// that their mean direction is the exact one and no border can be seen. 0.03 degrees.
constexpr double FanAzimuthStep = 0.03 * RadiansPerDegree;

/// Relative difference of the lengths of neighbouring rays. Slopes are brought to each post's own length;
/// only the part that the body's curvature takes, d (1 - k) / 2R, comes from the rays, again interpolated.
constexpr double FanLengthStep = 0.02;

/// Directions and lengths that serve all posts in one azimuth. A search with direction i and length j is
/// one with the metric of the field's centre, its lengths times exp(Lengths[j]), and the azimuth
/// Directions[i] on that metric.
class SKYLINECORE_EXPORT RayFan
{
public:
  /// azimuth: radians from the image's +y axis, on the image (`onImage`) or on the ground. curved: the
  /// body's curvature counts; without it one length serves all.
  RayFan(const GroundMetric& metric, double azimuth, bool onImage, bool curved);

  std::vector<double> Directions, Lengths; ///< rising, at least one each; directions in radians

  bool IsOne() const { return this->Directions.size() * this->Lengths.size() == 1; }

  /// The metric of the searches with length j.
  PostMetric MetricOf(std::size_t length) const;

  /// Where posts (column .. column + count - 1, row) lie among the directions and lengths: 1.25 is a
  /// quarter of the way from the second to the third.
  void Places(std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, float* directions,
    float* lengths) const;

private:
  const GroundMetric& Metric;
  PostMetric Reference;
  std::vector<float> Direction, Length; ///< of the metric's nodes, as places
};

} // namespace skyline

#endif
