// SPDX-License-Identifier: BSD-3-Clause
#include "Sun/Eclipse.h"

#include "Geo/LatticePlace.h"
#include "Shared/Constants.h"
#include "Sun/Astronomy.h"
#include "Sun/CoveredDisc.h"
#include "Sun/SunPosition.h"

#include <erfa.h>
#include <erfam.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace skyline
{
namespace
{

/// An eclipse is possible somewhere if the angle between the centres, seen from the centre of the
/// Earth, is less than this (radians): the greatest parallax of the Moon (1.03 degrees) plus both
/// greatest radii (0.28 and 0.27 degrees).
constexpr double FarthestEclipse = 1.6 * RadiansPerDegree;

using Vector = std::array<double, 3>;

double Length(const Vector& v)
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

Vector Minus(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

SunAndMoon See(const Vector& sun, const Vector& moon)
{
  const double toSun = Length(sun), toMoon = Length(moon);
  const double sunRadius = SolarRadius / toSun;
  SunAndMoon seen;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    seen.Offset[axis] = (moon[axis] / toMoon - sun[axis] / toSun) / sunRadius;
  }
  seen.Cover = LunarRadius / toMoon / sunRadius;
  return seen;
}

/// Bounds by how much the distance of the rims differs between two views, in radii of the sun.
double Difference(const SunAndMoon& a, const SunAndMoon& b)
{
  return Length(Minus(a.Offset, b.Offset)) + std::abs(a.Cover - b.Cover);
}

/// Returns true if the rims of the sun and the Moon may touch at a node, or between it and its
/// neighbours.
bool Reaches(const RefinedLattice<SunAndMoon>& lattice)
{
  double closest = lattice.Nodes.front().Distance(), step = 0.0;
  for (std::ptrdiff_t j = 0; j < lattice.Side; ++j)
  {
    for (std::ptrdiff_t i = 0; i < lattice.Side; ++i)
    {
      const SunAndMoon& node = lattice.At(i, j);
      closest = std::min(closest, node.Distance() - node.Cover - 1.0);
      step = std::max(step, i > 0 ? Difference(node, lattice.At(i - 1, j)) : 0.0);
      step = std::max(step, j > 0 ? Difference(node, lattice.At(i, j - 1)) : 0.0);
    }
  }
  return closest < step;
}

} // namespace

SunAndMoon Mix(const SunAndMoon& a, const SunAndMoon& b, double fraction)
{
  const double rest = 1.0 - fraction;
  SunAndMoon mixed;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    mixed.Offset[axis] = rest * a.Offset[axis] + fraction * b.Offset[axis];
  }
  mixed.Cover = rest * a.Cover + fraction * b.Cover;
  return mixed;
}

double SunAndMoon::Distance() const
{
  return Length(this->Offset);
}

double SunAndMoon::Magnitude() const
{
  return CoveredMagnitude(this->Distance(), this->Cover);
}

double SunAndMoon::Obscuration(double limbDarkening) const
{
  return CoveredShare(this->Distance(), this->Cover, limbDarkening);
}

EclipseEphemeris::EclipseEphemeris(const UtcTime& time, double ut1MinusUtc)
  : Sun(SunEphemeris(time, ut1MinusUtc).FromEarthCentre())
{
  const AstronomicalTimes times = ConvertUtc(time, ut1MinusUtc);
  double moon[2][3];
  eraMoon98(times.Tt1, times.Tt2, moon);
  const double light = eraPm(moon[0]) * ERFA_AULT / ERFA_DAYSEC; // light time in days
  for (int axis = 0; axis < 3; ++axis)
  {
    moon[0][axis] -= light * moon[1][axis];
  }
  double toTerrestrial[3][3], fixed[3];
  CelestialToTerrestrial(times, toTerrestrial);
  eraRxp(toTerrestrial, moon[0], fixed);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Moon[axis] = ERFA_DAU * fixed[axis];
  }
  double sun[3] = { this->Sun[0], this->Sun[1], this->Sun[2] };
  this->Near = eraSepp(sun, fixed) < FarthestEclipse;
}

SunAndMoon EclipseEphemeris::At(double longitude, double latitude, double height) const
{
  const Vector place = FromEarthCentre(longitude, latitude, height);
  return See(Minus(this->Sun, place), Minus(this->Moon, place));
}

EclipseField::EclipseField(const Georeference& place, const UtcTime& time, double meanHeight)
{
  if (!place.OnBody() || !place.Earth)
  {
    return;
  }
  const EclipseEphemeris ephemeris(time);
  if (!ephemeris.Possible())
  {
    return;
  }
  const auto at = [&](double column, double row)
  {
    double longitude = 0.0, latitude = 0.0;
    place.LonLatAt(column, row, longitude, latitude);
    return ephemeris.At(longitude, std::clamp(latitude, -90.0, 90.0), meanHeight);
  };
  this->Lattice.Refine(place, EclipseTolerance, at, Difference, Reaches);
}

SunAndMoon EclipseField::At(double column, double row) const
{
  return this->Lattice.Interpolate(column, row);
}

void EclipseField::Uncovered(std::ptrdiff_t row, std::ptrdiff_t columnBegin, std::ptrdiff_t count,
  double limbDarkening, float* share) const
{
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    const double column = static_cast<double>(columnBegin + i);
    share[i] = this->Any()
      ? static_cast<float>(
          1.0 - this->At(column, static_cast<double>(row)).Obscuration(limbDarkening))
      : 1.0f;
  }
}

} // namespace skyline
