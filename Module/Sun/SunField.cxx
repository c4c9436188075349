// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/SunField.h"

#include "Geo/Azimuth.h"
#include "Geo/LatticePlace.h"
#include "Shared/Constants.h"
#include "Sun/SunPosition.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace skyline
{
namespace
{

/// If all directions differ by less than this (degrees), the sun is the same at all posts: the
/// differences are rounding errors of a raster with perpendicular axes.
constexpr double SameDirection = 1e-6;

SunVector FromAngles(double azimuth, double elevation)
{
  const double a = azimuth * RadiansPerDegree, e = elevation * RadiansPerDegree;
  return { std::cos(e) * std::sin(a), std::cos(e) * std::cos(a), std::sin(e) };
}

/// Degrees between two vectors of approximately unit length.
double Angle(const SunVector& a, const SunVector& b)
{
  const double x = a.Y * b.Z - a.Z * b.Y, y = a.Z * b.X - a.X * b.Z, z = a.X * b.Y - a.Y * b.X;
  const double dot = a.X * b.X + a.Y * b.Y + a.Z * b.Z;
  return std::atan2(std::sqrt(x * x + y * y + z * z), dot) * DegreesPerRadian;
}

} // namespace

SunVector Mix(const SunVector& a, const SunVector& b, double fraction)
{
  const double rest = 1.0 - fraction;
  return { rest * a.X + fraction * b.X, rest * a.Y + fraction * b.Y, rest * a.Z + fraction * b.Z };
}

SunField::SunField(
  const Georeference& place, const UtcTime& time, double meanHeight, double ut1MinusUtc)
{
  if (place.OnBody() && !place.Earth)
  {
    throw std::invalid_argument("the sun's position at " + ToText(time) +
      " is known on the Earth only; on another body, give the azimuth and elevation of the sun");
  }
  const SunEphemeris ephemeris(time, ut1MinusUtc);
  const Air air = StandardAir(meanHeight);
  const double lastColumn = static_cast<double>(place.Columns - 1);
  const double lastRow = static_cast<double>(place.Rows - 1);
  const auto sunAt = [&](double column, double row)
  {
    double longitude = 0.0, latitude = 0.0;
    place.LonLatAt(column, row, longitude, latitude);
    return ephemeris.At(longitude, std::clamp(latitude, -90.0, 90.0), meanHeight, air);
  };
  this->DiscRadius = sunAt(0.5 * lastColumn, 0.5 * lastRow).AngularRadius;

  this->Fill(place,
    [&](double column, double row)
    {
      const SunDirection sun = sunAt(column, row);
      return FromAngles(place.AxisAzimuthAt(column, row, sun.Azimuth), sun.ApparentElevation);
    });
}

template <typename SunAt>
void SunField::Fill(const Georeference& place, const SunAt& vectorAt)
{
  this->Lattice.Refine(place, SunFieldTolerance, vectorAt, Angle,
    [](const RefinedLattice<SunVector>&) { return true; });
}

SunField SunField::Constant(double azimuth, double elevation, double radius)
{
  if (!std::isfinite(azimuth))
  {
    throw std::out_of_range("sun azimuth " + std::to_string(azimuth) +
      " is not a number; give degrees clockwise from grid north");
  }
  if (!(std::abs(elevation) <= 90.0))
  {
    throw std::out_of_range("sun elevation " + std::to_string(elevation) +
      " is outside -90 to 90; give degrees above the horizontal plane");
  }
  if (!(radius >= 0.0 && radius < 90.0))
  {
    throw std::out_of_range("sun radius " + std::to_string(radius) +
      " is outside 0 to 90; give degrees, 0.26645 for the sun seen from the Earth");
  }
  SunField field;
  field.Lattice.Side = 1;
  field.Lattice.Nodes.push_back(FromAngles(std::fmod(azimuth, 360.0), elevation));
  field.DiscRadius = radius;
  return field;
}

SunField SunField::OnImage(
  const Georeference& place, double azimuth, double elevation, double radius)
{
  SunField field = Constant(azimuth, elevation, radius);
  if (place.GroundAxes && place.OnBody())
  {
    field.Fill(place,
      [&](double column, double row)
      {
        const double direction = place.TrueAzimuthAt(column, row, std::fmod(azimuth, 360.0));
        return FromAngles(place.GroundAzimuthAt(column, row, direction), elevation);
      });
    const SunVector& first = field.Lattice.Nodes.front();
    if (std::all_of(field.Lattice.Nodes.begin(), field.Lattice.Nodes.end(),
          [&](const SunVector& node) { return Angle(first, node) <= SameDirection; }))
    {
      return Constant(azimuth, elevation, radius);
    }
  }
  return field;
}

GridSun SunField::At(double column, double row) const
{
  const SunVector sun = this->Lattice.Interpolate(column, row);
  GridSun result;
  result.Azimuth = AzimuthOf(sun.X, sun.Y);
  result.Elevation = std::atan2(sun.Z, std::hypot(sun.X, sun.Y)) * DegreesPerRadian;
  result.Radius = this->DiscRadius;
  return result;
}

void SunField::Row(std::ptrdiff_t row, std::ptrdiff_t columnBegin, std::ptrdiff_t count, float* x,
  float* y, float* z) const
{
  const RefinedLattice<SunVector>& lattice = this->Lattice;
  const LatticePlace along(static_cast<double>(row) * lattice.NodesPerRow, lattice.Side);
  std::ptrdiff_t cell = -1;
  SunVector west, east;
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    const LatticePlace across(
      static_cast<double>(columnBegin + i) * lattice.NodesPerColumn, lattice.Side);
    if (across.Lower != cell)
    {
      cell = across.Lower;
      west = Mix(lattice.At(across.Lower, along.Lower), lattice.At(across.Lower, along.Upper),
        along.Fraction);
      east = Mix(lattice.At(across.Upper, along.Lower), lattice.At(across.Upper, along.Upper),
        along.Fraction);
    }
    const SunVector sun = Mix(west, east, across.Fraction);
    const double scale = 1.0 / std::sqrt(sun.X * sun.X + sun.Y * sun.Y + sun.Z * sun.Z);
    x[i] = static_cast<float>(scale * sun.X);
    y[i] = static_cast<float>(scale * sun.Y);
    z[i] = static_cast<float>(scale * sun.Z);
  }
}

void SunField::AzimuthBounds(double& first, double& last) const
{
  std::vector<double> azimuths;
  for (const SunVector& node : this->Lattice.Nodes)
  {
    azimuths.push_back(AzimuthOf(node.X, node.Y));
  }
  std::sort(azimuths.begin(), azimuths.end());

  // The arc is the full circle without the widest gap.
  first = azimuths.front();
  last = azimuths.back();
  double widest = first + 360.0 - last;
  for (std::size_t i = 1; i < azimuths.size(); ++i)
  {
    if (azimuths[i] - azimuths[i - 1] > widest)
    {
      widest = azimuths[i] - azimuths[i - 1];
      first = azimuths[i];
      last = azimuths[i - 1] + 360.0;
    }
  }
  // If no half plane contains all directions, the zenith lies among them.
  if (widest < 180.0)
  {
    first = 0.0;
    last = 360.0;
  }
}

void SunField::ElevationBounds(double& least, double& greatest) const
{
  double low = 1.0, high = -1.0;
  for (const SunVector& node : this->Lattice.Nodes)
  {
    low = std::min(low, node.Z);
    high = std::max(high, node.Z);
  }
  least = std::asin(std::clamp(low, -1.0, 1.0)) * DegreesPerRadian;
  greatest = std::asin(std::clamp(high, -1.0, 1.0)) * DegreesPerRadian;
}

} // namespace skyline
