// SPDX-License-Identifier: BSD-3-Clause
// Skies that are given by formulas: the CIE standard general skies and the all-weather sky of
// Perez.
#ifndef skyline_SkyModel_h
#define skyline_SkyModel_h

#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// The radiance of a sky, except for a factor, at the elevation e and the angle x from the sun:
///   (1 + A exp(B / sin e)) (Base + C exp(D x) + E cos^2 x),
/// or, for the traditional overcast sky, 1 + 2 sin e.
struct SKYLINECORE_EXPORT SkyModel
{
  double A = 0.0, B = -1.0;                      ///< gradation from zenith to horizon
  double Base = 1.0, C = 0.0, D = -1.0, E = 0.0; ///< indicatrix around the sun
  bool Traditional = false;

  /// sine: of the elevation, above 0 to 1; cosToSun: cos x, -1 to 1. The result is never below 0.
  double Radiance(double sine, double cosToSun) const;

  /// Returns true if the sky looks the same in all azimuths.
  bool Zonal() const { return this->C == 0.0 && this->E == 0.0; }
};

/// Number of the traditional overcast sky (Moon & Spencer 1942) in CIE S 011/E:2003. The standard
/// general skies have the numbers 1 to 15.
constexpr int TraditionalOvercast = 16;

/// A sky of CIE S 011/E:2003 (ISO 15469:2004), table 1: 1 to 5 are overcast (5 is uniform), 6 to 10
/// partly cloudy, 11 to 15 clear, and 16 is the traditional overcast sky. Throws
/// std::invalid_argument for other numbers.
SKYLINECORE_EXPORT SkyModel CieSky(int type);

/// The all-weather sky of Perez, Seals & Michalsky, Solar Energy 50 (1993), table 1, for the
/// clearness and brightness that follow from
///   direct: normal irradiance of the sun, W/m^2, 0 or more;
///   diffuse: horizontal irradiance of the sky, W/m^2, above 0;
///   sunElevation: apparent, radians, above 0.
/// Throws std::invalid_argument for other values.
SKYLINECORE_EXPORT SkyModel PerezSky(double direct, double diffuse, double sunElevation);

/// Irradiance of the sun above the atmosphere, W/m^2, which Perez uses to compute the brightness of
/// the sky.
constexpr double SolarConstant = 1367.0;

/// How the radiance of a sky is scaled.
struct SkyScale
{
  bool ByIrradiance = false; ///< true: Value is the irradiance on open level ground; false: the
                             ///< zenith radiance
  double Value = 1.0;        ///< irradiance or radiance
};

/// Fills a light map (LightMap.h) of width x height pixels (2 or more, height even) with a sky.
/// Each pixel is the mean over four points inside it; all three colours are equal; there is no
/// light below the horizon. The sun is at sunAzimuth (radians clockwise from the north of the map)
/// and sunElevation. Throws std::invalid_argument if the sky cannot be scaled (because the zenith
/// is dark or there is no light at all).
SKYLINECORE_EXPORT void FillSky(const SkyModel& sky, double sunAzimuth, double sunElevation,
  const SkyScale& scale, int width, int height, float* rgb);

/// Number of pixels around the horizon for which the irradiance of all skies above has an error of
/// at most 0.05 %.
constexpr int SkyWidth = 720;
constexpr int SkyHeight = 360;

} // namespace skyline

#endif
