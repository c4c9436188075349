// SPDX-License-Identifier: BSD-3-Clause
// The allowed difference between the horizons of a method and those of the oracle, for each post.
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

/// A method and the settings with which it is tested.
struct TestedMethod
{
  const char* Name;
  HorizonMethodKind Kind;
  double Tolerance; ///< radians below the true horizon, besides rounding; negative: no bound
};

/// One degree: with it, segments are skipped by their bounds far more often.
constexpr double ExactTolerance = 1.0 * RadiansPerDegree;

inline const std::vector<TestedMethod>& TestedMethods()
{
  static const std::vector<TestedMethod> methods{ { "exact", HorizonMethodKind::Exact, 0.0 },
    { "exact with a tolerance", HorizonMethodKind::Exact, ExactTolerance },
    { "fast", HorizonMethodKind::Fast, FastTolerance }, { "sweep", HorizonMethodKind::Sweep, -1.0 },
    { "pyramid", HorizonMethodKind::Pyramid, -1.0 } };
  return methods;
}

/// The difference between the greatest and the least height, metres.
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

/// The change of a horizon's slope by the rounding of heights to floats. The heights of receiver
/// and edge are rounded to 2^-24 of half the relief, their difference and its weights are each
/// rounded once more, over at least the shorter step, and the slope itself is a float. The rounding
/// of the weights is that of the position: 2^-24 of a step at the steepest edge, which again is the
/// relief.
inline double SlopeRounding(const oracle::OracleField& field, double slope)
{
  constexpr double unit = 5.96e-8; // 2^-24
  const double step = std::min(field.SpacingX, field.SpacingY);
  return unit * (8.0 * ReliefOf(field) / step + 4.0 * std::abs(slope));
}

/// The allowed error of a horizon in degrees: the angle that corresponds to the rounding of the
/// slope, which is small for steep horizons, plus the rounding of the arc.
inline double ElevationRounding(const oracle::OracleField& field, double slope)
{
  const double rounding = SlopeRounding(field, slope);
  return (std::atan(slope + rounding) - std::atan(slope - rounding)) * DegreesPerRadian + 2.0e-5;
}

/// For all methods the elevation of the horizon is, in absolute value, at most that of the whole
/// relief at a distance of one step.
inline double ElevationLimit(const oracle::OracleField& field)
{
  const double step = std::min(field.SpacingX, field.SpacingY);
  return std::atan(ReliefOf(field) / step * (1.0 + 1.0e-5)) * DegreesPerRadian + 2.0e-5;
}

/// Whether an elevation (degrees) is within the bounds of the method where the oracle finds
/// `slope`.
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

/// Describes the first post whose slope is outside the bounds of the method; empty if there is
/// none. Posts without a reference value are missing and are skipped.
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
