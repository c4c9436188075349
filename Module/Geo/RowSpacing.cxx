// SPDX-License-Identifier: BSD-3-Clause
#include "Geo/RowSpacing.h"

#include "Geo/GroundMetric.h"
#include "Shared/Constants.h"

#include <GeographicLib/Geodesic.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace skyline
{
namespace
{

/// Geodesics are accurate to some nanometres, which is negligible over a metre.
constexpr double ShortestBase = 1.0;         // metres
constexpr double ShortestBaseDegrees = 1e-5; // degrees, a metre on the Earth

void CheckSteps(double x, double y)
{
  if (!(x > 0.0) || !(y > 0.0) || !std::isfinite(x) || !std::isfinite(y))
  {
    throw std::invalid_argument("spacing " + std::to_string(x) + " x " + std::to_string(y) +
      " is not positive; give the raster's steps as lengths");
  }
}

/// Refuses steps of more than 180 degrees, whose ends are nearer to each other the other way
/// around.
void CheckDegrees(double x, double y)
{
  if (x > 180.0 || y > 180.0)
  {
    throw std::invalid_argument("steps of " + std::to_string(x) + " x " + std::to_string(y) +
      " degrees go around the whole body; correct the file's geotransform");
  }
}

/// Number of whole posts that span at least `shortest`.
double Posts(double step, double shortest)
{
  return std::max(1.0, std::ceil(shortest / step));
}

/// Measures true lengths around the middle of a row.
class Ruler
{
public:
  explicit Ruler(const Georeference& place)
    : Place(place)
    , Ellipsoid(place.EquatorialRadius, place.Flattening)
    , Column(0.5 * static_cast<double>(place.Columns - 1))
  {
  }

  /// The spacing for steps in degrees of longitude and latitude.
  PostSpacing Geographic(double row, double stepX, double stepY) const
  {
    double longitude = 0.0, latitude = 0.0;
    this->Place.LonLatAt(this->Column, row, longitude, latitude);
    // A post at the pole may miss it by rounding, but half a step beyond the pole there is no
    // place.
    if (!(std::abs(latitude) < 90.0 + 0.25 * stepY))
    {
      throw std::invalid_argument("row " + std::to_string(row) + " lies at latitude " +
        std::to_string(latitude) + ", beyond the pole; correct the file's geotransform");
    }

    const double acrossX = Posts(stepX, ShortestBaseDegrees) * stepX;
    const double reach = 90.0 - 0.25 * std::min(stepY, 180.0);
    const double offPole = std::clamp(latitude, -reach, reach);
    const double alongY = Posts(stepY, ShortestBaseDegrees) * stepY;
    const double from = std::clamp(latitude - 0.5 * alongY, -90.0, 90.0);
    const double to = std::clamp(latitude + 0.5 * alongY, -90.0, 90.0);

    PostSpacing spacing;
    spacing.X = this->Length(offPole, longitude, offPole, longitude + acrossX) * stepX / acrossX;
    spacing.Y = this->Length(from, longitude, to, longitude) * stepY / (to - from);
    return spacing;
  }

  /// The spacing for steps in metres on the map.
  PostSpacing Projected(double row, double stepX, double stepY) const
  {
    const double acrossX = Posts(stepX, ShortestBase);
    const double alongY = Posts(stepY, ShortestBase);
    PostSpacing spacing;
    spacing.X = this->Between(this->Column - 0.5 * acrossX, row, this->Column + 0.5 * acrossX, row);
    spacing.Y = this->Between(this->Column, row - 0.5 * alongY, this->Column, row + 0.5 * alongY);
    spacing.X /= acrossX;
    spacing.Y /= alongY;
    return spacing;
  }

private:
  double Length(double latitude0, double longitude0, double latitude1, double longitude1) const
  {
    double metres = 0.0;
    this->Ellipsoid.Inverse(latitude0, longitude0, latitude1, longitude1, metres);
    return metres;
  }

  double Between(double column0, double row0, double column1, double row1) const
  {
    double longitude0 = 0.0, latitude0 = 0.0, longitude1 = 0.0, latitude1 = 0.0;
    this->Place.LonLatAt(column0, row0, longitude0, latitude0);
    this->Place.LonLatAt(column1, row1, longitude1, latitude1);
    return this->Length(latitude0, longitude0, latitude1, longitude1);
  }

  const Georeference& Place;
  GeographicLib::Geodesic Ellipsoid;
  double Column;
};

bool Near(double value, double reference, double tolerance)
{
  return std::abs(value - reference) <= tolerance * reference;
}

bool Near(const PostSpacing& value, const PostSpacing& reference, double tolerance)
{
  return Near(value.X, reference.X, tolerance) && Near(value.Y, reference.Y, tolerance);
}

} // namespace

PostSpacing ComputeRowSpacing(Georeference& place, double nominalX, double nominalY, StepUnit unit)
{
  CheckSteps(nominalX, nominalY);
  if (unit != StepUnit::Metres)
  {
    CheckDegrees(nominalX, nominalY);
  }
  place.RowSpacingX.clear();
  place.RowSpacingY.clear();
  place.InDegrees = unit != StepUnit::Metres;
  const PostSpacing nominal{ nominalX, nominalY };
  if (unit == StepUnit::Metres)
  {
    const double extent = std::max(
      nominalX * static_cast<double>(place.Columns), nominalY * static_cast<double>(place.Rows));
    if (!place.OnBody() || extent < ShortestBase || GroundMetric(place, nominal).Uniform())
    {
      return nominal;
    }
  }

  double longitude = 0.0, latitude = 0.0;
  place.LonLatAt(0.0, 0.0, longitude, latitude); // throws if there is no body
  if (unit != StepUnit::Degrees && !place.FollowsGraticule())
  {
    const double metres =
      unit == StepUnit::Metres ? 1.0 : place.EquatorialRadius * RadiansPerDegree; // approximate
    const PostMetric centre =
      GroundMetric(place, { metres * nominalX, metres * nominalY }).Centre();
    return { std::hypot(centre.X, centre.Shear), centre.Y };
  }
  const Ruler ruler(place);
  const auto measure = [&](double row)
  {
    const PostSpacing found = unit == StepUnit::Metres ? ruler.Projected(row, nominalX, nominalY)
                                                       : ruler.Geographic(row, nominalX, nominalY);
    CheckSteps(found.X, found.Y); // too small for double, or no inverse of the map here
    return found;
  };
  const PostSpacing centre = measure(0.5 * static_cast<double>(place.Rows - 1));

  std::vector<double> x, y;
  bool uniform = true;
  for (std::ptrdiff_t row = 0; row < place.Rows; ++row)
  {
    const PostSpacing spacing = measure(static_cast<double>(row));
    uniform = uniform && Near(spacing, centre, RowSpacingUniformity);
    x.push_back(spacing.X);
    y.push_back(spacing.Y);
  }
  if (!uniform)
  {
    place.RowSpacingX = std::move(x);
    place.RowSpacingY = std::move(y);
  }
  return centre;
}

} // namespace skyline
