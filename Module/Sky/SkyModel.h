// SPDX-License-Identifier: BSD-3-Clause
// Skies given by formulas: the CIE standard general skies and Perez's all-weather sky.
#ifndef skyline_SkyModel_h
#define skyline_SkyModel_h

#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// The radiance of a sky up to a factor, at an elevation e and an angle x from the sun:
///   (1 + A exp(B / sin e)) (Base + C exp(D x) + E cos^2 x),
/// or, for the traditional overcast sky, 1 + 2 sin e.
struct SKYLINECORE_EXPORT SkyModel
{
  double A = 0.0, B = -1.0;                      ///< gradation from zenith to horizon
  double Base = 1.0, C = 0.0, D = -1.0, E = 0.0; ///< indicatrix around the sun
  bool Traditional = false;

  /// sine: of the elevation, above 0 to 1; cosToSun: cos x, -1 to 1. Never below 0.
  double Radiance(double sine, double cosToSun) const;

  /// Whether the sky looks the same in all azimuths.
  bool Zonal() const { return this->C == 0.0 && this->E == 0.0; }
};

/// Number of the traditional overcast sky (Moon & Spencer 1942) in CIE S 011/E:2003; the standard
/// general skies have 1 to 15.
constexpr int TraditionalOvercast = 16;

/// A sky of CIE S 011/E:2003 (ISO 15469:2004), table 1: 1 to 5 overcast (5 uniform), 6 to 10 partly
/// cloudy, 11 to 15 clear, 16 the traditional overcast sky. std::invalid_argument for another
/// number.
SKYLINECORE_EXPORT SkyModel CieSky(int type);

/// The all-weather sky of Perez, Seals & Michalsky, Solar Energy 50 (1993), table 1, chosen by the
/// clearness and brightness of
///   direct: normal irradiance of the sun, W/m^2, 0 or more;
///   diffuse: horizontal irradiance of the sky, W/m^2, above 0;
///   sunElevation: apparent, radians, above 0.
/// std::invalid_argument for others.
SKYLINECORE_EXPORT SkyModel PerezSky(double direct, double diffuse, double sunElevation);

/// Irradiance of the sun above the air, W/m^2, as Perez uses it for the sky's brightness.
constexpr double SolarConstant = 1367.0;

/// How the radiance of a sky is scaled.
struct SkyScale
{
  bool ByIrradiance = false; ///< Value is the irradiance of open level ground, else the zenith's
  double Value = 1.0;        ///< radiance
};

/// Fills a light map (LightMap.h) of width x height pixels (2 or more, height even) with a sky: each
/// pixel the mean over four places inside it, all three colours alike; nothing below the horizon.
/// The sun stands at sunAzimuth (radians clockwise from the map's north) and sunElevation.
/// std::invalid_argument if the sky cannot be scaled (a dark zenith, no light at all).
SKYLINECORE_EXPORT void FillSky(const SkyModel& sky, double sunAzimuth, double sunElevation,
  const SkyScale& scale, int width, int height, float* rgb);

/// Pixels around the horizon that keep the irradiance of every sky above within 0.05 %.
constexpr int SkyWidth = 720;
constexpr int SkyHeight = 360;

} // namespace skyline

#endif
