// SPDX-License-Identifier: BSD-3-Clause
// The position of the sun in the sky of a place on the Earth.
#ifndef skyline_SunPosition_h
#define skyline_SunPosition_h

#include "SkylineCoreModule.h" // for the export macro
#include "Sun/Refraction.h"
#include "Sun/UtcTime.h"

#include <array>

namespace skyline
{

/// Radius of the sun in metres: nominal solar radius of IAU 2015 resolution B3 (695700 km).
constexpr double SolarRadius = 6.957e8;

/// The sun seen from a place.
struct SunDirection
{
  double Azimuth = 0.0;            ///< degrees clockwise from true north, from 0 to below 360
  double Elevation = 90.0;         ///< degrees above the horizontal plane, without air
  double ApparentElevation = 90.0; ///< degrees, lifted by the air
  double AngularRadius = 0.0;      ///< degrees, at the distance of the observer
};

/// The sun at one moment. The expensive part of its position is computed once for all places.
///
/// Method: ERFA, the library form of SOFA of the IAU. UTC is converted to TAI and TT with its leap
/// seconds. The Earth is computed by eraEpv00 (Simon & others 2001, fitted to DE405), annual
/// aberration by eraAb, frame bias, precession and nutation by eraC2i06a (IAU 2006/2000A), and
/// rotation by eraEra00. The result is the position of the sun in metres in the Earth-fixed frame,
/// from which the position of a place is subtracted (topocentric parallax).
///
/// Errors: UT1 - UTC is taken as 0 if it is not given; it stays within 0.9 s, which rotates the sky
/// by at most 0.0038 degrees. Polar motion, diurnal aberration (0.3 arcseconds each) and TDB - TT
/// are left out: 0.0002 degrees. UTC is not defined before 1960 (the time then counts as UT1, and
/// TT - UT1 as 32.184 s, with an error of up to 35 s: 0.0004 degrees). Leap seconds of future years
/// are unknown: there the given time is as good as UT1 while UTC follows the Earth (the error of TT
/// by 2100 is about 2 minutes: 0.0015 degrees).
class SKYLINECORE_EXPORT SunEphemeris
{
public:
  /// `ut1MinusUtc`: seconds, within -1 to 1, default 0 (published in IERS Bulletin A). Throws
  /// std::out_of_range for a time outside 1900 to 2100, where eraEpv00 ends, and
  /// std::invalid_argument for a date or a time of day that does not exist.
  explicit SunEphemeris(const UtcTime& time, double ut1MinusUtc = 0.0);

  /// The sun seen from a longitude (degrees east), latitude (degrees north, geodetic, -90 to 90)
  /// and height (metres above the WGS 84 ellipsoid; heights above the sea are accurate enough).
  /// Throws std::out_of_range for a latitude beyond the poles and for numbers that are not finite.
  SunDirection At(double longitude, double latitude, double height, const Air& air) const;

  /// Metres from the centre of the Earth, on axes fixed to the Earth.
  const std::array<double, 3>& FromEarthCentre() const { return this->Sun; }

private:
  std::array<double, 3> Sun; ///< metres from the centre of the Earth, axes fixed to the Earth; with
                             ///< aberration
};

/// The sun at one place and one time: SunEphemeris(time, ut1MinusUtc).At(...).
SKYLINECORE_EXPORT SunDirection ComputeSun(const UtcTime& time, double longitude, double latitude,
  double height, const Air& air, double ut1MinusUtc = 0.0);

} // namespace skyline

#endif
