// SPDX-License-Identifier: BSD-3-Clause
// How far the horizons of a method may lie from the oracle's, post by post.
#ifndef skyline_HorizonBounds_h
#define skyline_HorizonBounds_h

#include "Reference/OracleTerrain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace skyline
{
namespace testing
{

/// A method with the settings that it is tested with.
struct TestedMethod
{
  const char* Name;
  HorizonMethodKind Kind;
  double Tolerance; ///< radians that it may fall short by, beside rounding; below 0: no statement
};

/// A degree: with it the bounds of segments are passed over far more often than without.
constexpr double ExactTolerance = 1.0 * RadiansPerDegree;

inline const std::vector<TestedMethod>& TestedMethods()
{
  static const std::vector<TestedMethod> methods{ { "exact", HorizonMethodKind::Exact, 0.0 },
    { "exact with a tolerance", HorizonMethodKind::Exact, ExactTolerance },
    { "fast", HorizonMethodKind::Fast, FastTolerance }, { "sweep", HorizonMethodKind::Sweep, -1.0 },
    { "pyramid", HorizonMethodKind::Pyramid, -1.0 } };
  return methods;
}

/// The spread of heights, metres.
inline double ReliefOf(const oracle::OracleField& field)
{
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double height : field.Heights)
  {
    low = std::isfinite(height) ? std::min(low, height) : low;
    high = std::isfinite(height) ? std::max(high, height) : high;
  }
  return high - low;
}

/// Slope by which float heights move a horizon: heights of receiver and edge are rounded to 2^-24 of
/// half the relief, their difference and its weights once more each, over the shorter step at least,
/// and the slope itself is a float. The weights' own rounding is that of the place: 2^-24 of a step at
/// the steepest edge, which is the relief again.
inline double SlopeRounding(const oracle::OracleField& field, double slope)
{
  constexpr double unit = 5.96e-8; // 2^-24
  const double step = std::min(field.SpacingX, field.SpacingY);
  return unit * (8.0 * ReliefOf(field) / step + 4.0 * std::abs(slope));
}

/// What a horizon of the slope may be off by, degrees: the angle that the rounding of slopes spans
/// there, which is little where the horizon is steep; and the arc's own float.
inline double ElevationRounding(const oracle::OracleField& field, double slope)
{
  const double rounding = SlopeRounding(field, slope);
  return (std::atan(slope + rounding) - std::atan(slope - rounding)) * DegreesPerRadian + 2.0e-5;
}

/// No horizon of any method lies above that of the whole relief one step away, nor that much below.
inline double ElevationLimit(const oracle::OracleField& field)
{
  const double step = std::min(field.SpacingX, field.SpacingY);
  return std::atan(ReliefOf(field) / step * (1.0 + 1.0e-5)) * DegreesPerRadian + 2.0e-5;
}

/// Whether an elevation (degrees) is what the method promises where the oracle finds `slope`.
inline bool Keeps(
  const oracle::OracleField& field, const TestedMethod& method, double found, double slope)
{
  if (!(found >= -90.0 && found <= 90.0))
  {
    return false;
  }
  if (method.Tolerance < 0.0)
  {
    return found <= ElevationLimit(field);
  }
  const double right = oracle::ElevationDegrees(slope);
  const double rounding = slope == oracle::NoTerrain ? 0.0 : ElevationRounding(field, slope);
  return found <= right + rounding &&
    found >= right - method.Tolerance * DegreesPerRadian - rounding;
}

/// The first post whose slope is not what the method promises; empty if there is none. Posts without a
/// truth are missing.
inline std::string FirstComplaint(const oracle::OracleField& field, const TestedMethod& method,
  const std::vector<float>& found, const std::vector<double>& truth)
{
  for (std::size_t post = 0; post < truth.size(); ++post)
  {
    const double elevation = Elevation(found[post]);
    if (!std::isnan(truth[post]) && !Keeps(field, method, elevation, truth[post]))
    {
      return std::string(method.Name) + " finds " + std::to_string(elevation) + ", the oracle " +
        std::to_string(oracle::ElevationDegrees(truth[post])) + " degrees at post " +
        std::to_string(post) + "; rounding is " +
        std::to_string(ElevationRounding(field, truth[post]));
    }
  }
  return "";
}

} // namespace testing
} // namespace skyline

#endif
