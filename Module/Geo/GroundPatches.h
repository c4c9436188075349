// SPDX-License-Identifier: BSD-3-Clause
// The division of a height field into patches with one metric each.
#ifndef skyline_GroundPatches_h
#define skyline_GroundPatches_h

#include "GroundMetric.h"

#include <cstddef>
#include <vector>

namespace skyline
{

/// A ray may leave its receiver this much beside its azimuth (degrees), because its patch has one metric:
/// AzimuthTolerance less what the lattice and its interpolation bring.
constexpr double PatchAzimuthTolerance = 0.04;

/// Lengths inside a patch may differ this much (relative) from those of its metric. Slopes are corrected
/// for it post by post; only the part that curvature takes, d (1 - k) / 2R, is not, and errs by twice as
/// much: 0.008 degrees at most for a horizon 100 km away on the Earth.
constexpr double PatchScaleTolerance = 0.01;

/// Posts on either side of the border of two patches over which one passes into the other.
constexpr std::ptrdiff_t BlendPosts = 16;

/// Posts [Begin, End) with a weight each.
struct PatchSide
{
  std::ptrdiff_t Begin = 0, End = 0;
  double Middle = 0.0;        ///< the post whose metric counts
  std::vector<float> Weights; ///< of Begin and on; empty: 1
};

/// Columns and rows, each divided into overlapping sides whose weights add up to 1 at every post. Every
/// pair of a side of columns and one of rows is a patch.
struct GroundPatches
{
  std::vector<PatchSide> Columns, Rows;

  std::size_t Count() const { return this->Columns.size() * this->Rows.size(); }
};

/// The fewest sides within the tolerances (radians, relative; infinite: it does not matter).
GroundPatches DivideGround(const GroundMetric& metric, double azimuthTolerance, double scaleTolerance);

} // namespace skyline

#endif
