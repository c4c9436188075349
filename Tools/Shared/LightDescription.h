// SPDX-License-Identifier: BSD-3-Clause
// The lights that somebody asked for, as numbers: the command line and the window fill it, and Lights.h
// makes VTK's light objects of it.
#ifndef skyline_LightDescription_h
#define skyline_LightDescription_h

#include "Sky/SkyDescription.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace skyline
{

/// Where the sun stands, in degrees.
struct SunAngles
{
  double Azimuth = 315.0;  ///< clockwise from grid north, any number of turns
  double Elevation = 45.0; ///< apparent, -90 to 90
};

/// A sun: of a time, in a direction, or neither (then the direction's defaults count).
struct SunDescription
{
  std::string Time; ///< as ParseUtcTime reads it; empty: none
  std::optional<SunAngles> Direction;
  std::optional<double> Radius; ///< degrees; none: that of the time, or the mean one
  std::optional<std::array<double, 3>>
    Irradiance; ///< on a plane that faces it; none: SunIrradianceOf
  bool LimbDarkening = false;

  /// Whether somebody asked for a sun.
  bool Asked() const { return !this->Time.empty() || this->Direction; }
};

/// A glowing ball.
struct LampDescription
{
  double X = 0.0,
         Y = 0.0; ///< in the coordinate system of the DEM; metres from its image's origin without
  double Z = 0.0; ///< metres, as the heights
  double Radius = 1.0; ///< metres, above 0
  std::array<double, 3> Radiance{ { 1.0, 1.0, 1.0 } };
  std::string Text; ///< as it was written, for messages
};

/// All lights.
struct LightDescription
{
  std::optional<SkyDescription> Sky; ///< none: a uniform one, if there is no other light
  double Rotation = 0.0; ///< degrees, any number of turns, by which the sky is turned clockwise
  SunDescription Sun;
  std::vector<LampDescription> Lamps;

  SkyKind KindOfSky() const { return this->Sky ? this->Sky->Kind : SkyKind::Uniform; }
};

/// The sun's irradiance as asked for; else that of a Perez sky's sun, else 1.
std::array<double, 3> SunIrradianceOf(const LightDescription& lights);

} // namespace skyline

#endif
