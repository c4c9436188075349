// SPDX-License-Identifier: BSD-3-Clause
// Eclipses of the sun: how much of its disc the Moon covers.
#ifndef skyline_Eclipse_h
#define skyline_Eclipse_h

#include "Geo/Georeference.h"
#include "SkylineCoreModule.h" // for the export macro
#include "Sun/RefinedLattice.h"
#include "Sun/UtcTime.h"

#include <array>
#include <cstddef>
#include <vector>

namespace skyline
{

/// Radius of the Moon in metres: k = 0.2725076 (IAU 1982, mean limb) times the equatorial radius of
/// the Earth (6378137 m, WGS 84).
constexpr double LunarRadius = 0.2725076 * 6378137.0;

/// Largest error, in radii of the sun, that interpolation may cause in the position of the Moon
/// relative to the sun. It changes the light of the sun by at most 0.0002, because the covered
/// share changes by less than 2 / pi per radius.
constexpr double EclipseTolerance = 0.0002;

/// The sun and the Moon seen from a place, without air. (Air lifts and flattens both alike, so that
/// the covered share is the same.)
struct SKYLINECORE_EXPORT SunAndMoon
{
  /// From the centre of the sun to that of the Moon, in radii of the sun, on axes fixed to the
  /// Earth.
  std::array<double, 3> Offset{ { 0.0, 0.0, 0.0 } };
  double Cover = 1.0; ///< radius of the Moon, in radii of the sun

  double Distance() const;  ///< between the centres, in radii of the sun
  double Magnitude() const; ///< covered part of the diameter of the sun: see CoveredMagnitude
  double Obscuration(double limbDarkening = 0.0) const; ///< see CoveredShare
};

/// The sun and the Moon at one moment.
///
/// Method: the sun as in SunEphemeris; the Moon by eraMoon98 (Meeus 1998) at the moment when its
/// light left it, rotated to axes fixed to the Earth in the same way. The position of a place is
/// subtracted (topocentric parallax).
///
/// Errors: eraMoon98 has an error in direction of 2.9 arcseconds (root mean square; at most 18),
/// which the Moon passes in 7 s in front of the sun. UT1 - UTC is taken as 0 if it is not
/// given, which moves the place by up to 0.9 s of the rotation of the Earth: 0.4 km. The limb of
/// the Moon has mountains and valleys of 2 arcseconds, and k is their mean: totality is 3 s shorter
/// in tables that use the smaller k = 0.272281 (valleys). Before 1960, terrestrial time has an
/// error of up to 35 s (SunEphemeris), and eclipses are early or late by as much.
class SKYLINECORE_EXPORT EclipseEphemeris
{
public:
  /// Throws what SunEphemeris throws.
  explicit EclipseEphemeris(const UtcTime& time, double ut1MinusUtc = 0.0);

  /// False where the Moon covers none of the sun anywhere on the Earth.
  bool Possible() const { return this->Near; }

  /// The place as SunEphemeris::At takes it, and with its errors.
  SunAndMoon At(double longitude, double latitude, double height) const;

  /// The Moon, metres from the Earth's centre, on axes fixed to the Earth.
  const std::array<double, 3>& MoonFromEarthCentre() const { return this->Moon; }

private:
  std::array<double, 3> Sun, Moon; ///< from the Earth's centre, metres, Earth-fixed axes
  bool Near = false;
};

SunAndMoon Mix(const SunAndMoon& a, const SunAndMoon& b, double fraction);

/// Sun and Moon over a whole height field at one time, computed at the nodes of a lattice that is
/// refined until interpolation keeps EclipseTolerance.
class SKYLINECORE_EXPORT EclipseField
{
public:
  /// No eclipse, anywhere.
  EclipseField() = default;

  /// As SunField; `meanHeight` (metres) stands for all posts: a kilometre moves the Moon by 0.5
  /// arcseconds. Off the Earth, and without a place, there is no eclipse. Throws what SunEphemeris
  /// throws.
  EclipseField(const Georeference& place, const UtcTime& time, double meanHeight);

  /// False where the Moon covers none of the sun at any post: then nothing is kept, and the sun and
  /// the Moon were compared once.
  bool Any() const { return !this->Lattice.Nodes.empty(); }

  /// Only if Any().
  SunAndMoon At(double column, double row) const;

  /// Only if Any(). The share of the sun's light that the Moon leaves, 0 to 1, at the `count` posts
  /// (columnBegin + i, row).
  void Uncovered(std::ptrdiff_t row, std::ptrdiff_t columnBegin, std::ptrdiff_t count,
    double limbDarkening, float* share) const;

private:
  RefinedLattice<SunAndMoon> Lattice; ///< no nodes: no eclipse
};

} // namespace skyline

#endif
