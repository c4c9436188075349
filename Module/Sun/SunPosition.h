// SPDX-License-Identifier: BSD-3-Clause
// Where the sun stands in the sky of a place on the Earth.
#ifndef skyline_SunPosition_h
#define skyline_SunPosition_h

#include "SkylineCoreModule.h" // for the export macro
#include "Sun/Refraction.h"
#include "Sun/UtcTime.h"

#include <array>

namespace skyline
{

/// Radius of the sun, metres: nominal solar radius of IAU 2015 resolution B3 (695700 km).
constexpr double SolarRadius = 6.957e8;

/// The sun seen from a place.
struct SunDirection
{
  double Azimuth = 0.0;            ///< degrees clockwise from true north, 0 up to 360
  double Elevation = 90.0;         ///< degrees above the horizontal plane, without air
  double ApparentElevation = 90.0; ///< degrees, lifted by the air
  double AngularRadius = 0.0;      ///< degrees, from the observer's distance
};

/// The sun at one moment; the costly part of its position, done once for all places.
///
/// Method: ERFA, the library form of the IAU's SOFA. UTC to TAI and TT by its leap seconds, the
/// Earth by eraEpv00 (Simon & others 2001, fitted to DE405), annual aberration by eraAb, frame
/// bias, precession and nutation by eraC2i06a (IAU 2006/2000A), rotation by eraEra00; then the
/// sun's place in metres in the Earth-fixed frame, from which a place subtracts its own
/// (topocentric parallax).
///
/// Errors: UT1 - UTC, when not given, counts as 0; it stays within 0.9 s, which turns the sky by at
/// most 0.0038 degrees. Polar motion, diurnal aberration (0.3 arcseconds each) and TDB - TT are
/// left out: 0.0002 degrees. UTC has no history before 1960 (the time is then UT1, and TT - UT1
/// counts as 32.184 s, wrong by up to 35 s: 0.0004 degrees) and no known leap seconds in years to
/// come: there the given time is as good as UT1 while UTC follows the Earth (error of TT by 2100
/// about 2 minutes: 0.0015 degrees).
class SKYLINECORE_EXPORT SunEphemeris
{
public:
  /// `ut1MinusUtc`: seconds, within -1 to 1, default 0 (IERS Bulletin A tells it).
  /// Throws std::out_of_range for a time outside 1900 to 2100, where eraEpv00 ends, and
  /// std::invalid_argument for a calendar date or clock time that does not exist.
  explicit SunEphemeris(const UtcTime& time, double ut1MinusUtc = 0.0);

  /// The sun seen from longitude (degrees east), latitude (degrees north, geodetic, -90 to 90) and
  /// height (metres above the ellipsoid of WGS 84; the sea level does as well). Throws
  /// std::out_of_range for a latitude beyond the poles or numbers that are not finite.
  SunDirection At(double longitude, double latitude, double height, const Air& air) const;

  /// Metres from the Earth's centre, on axes fixed to the Earth.
  const std::array<double, 3>& FromEarthCentre() const { return this->Sun; }

private:
  std::array<double, 3> Sun; ///< from the Earth's centre, metres, Earth-fixed axes, aberration in
};

/// One place at one time: SunEphemeris(time, ut1MinusUtc).At(...).
SKYLINECORE_EXPORT SunDirection ComputeSun(const UtcTime& time, double longitude, double latitude,
  double height, const Air& air, double ut1MinusUtc = 0.0);

} // namespace skyline

#endif
