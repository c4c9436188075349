// SPDX-License-Identifier: BSD-3-Clause
// The lights that the user wants, as numbers. The command line and the window fill this
// description; Lights.h makes VTK light objects from it.
#ifndef skyline_LightDescription_h
#define skyline_LightDescription_h

#include "Sky/SkyDescription.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace skyline
{

/// The position of the sun in degrees.
struct SunAngles
{
  double Azimuth = 315.0;  ///< clockwise from grid north, any number of turns
  double Elevation = 45.0; ///< apparent, -90 to 90
};

/// A sun: at a time, in a direction, or neither (then the default direction is used).
struct SunDescription
{
  std::string Time; ///< as ParseUtcTime reads it; empty: none
  std::optional<SunAngles> Direction;
  std::optional<double> Radius; ///< degrees; empty: the true one at that time, or the mean one
  std::optional<std::array<double, 3>>
    Irradiance; ///< on a plane that faces it; empty: SunIrradianceOf
  bool LimbDarkening = false;

  /// Returns whether the user wants a sun.
  bool Asked() const { return !this->Time.empty() || this->Direction; }
};

/// A glowing ball.
struct LampDescription
{
  double X = 0.0,
         Y = 0.0;      ///< in the CRS of the DEM; without one, metres from the origin of its image
  double Z = 0.0;      ///< metres, like the heights
  double Radius = 1.0; ///< metres, above 0
  std::array<double, 3> Radiance{ { 1.0, 1.0, 1.0 } };
  std::string Text; ///< as the user wrote it, for messages
};

/// All lights.
struct LightDescription
{
  std::optional<SkyDescription> Sky; ///< empty: a uniform sky if there is no other light
  double Rotation = 0.0; ///< degrees by which the sky is turned clockwise, any number of turns
  SunDescription Sun;
  std::vector<LampDescription> Lamps;

  SkyKind KindOfSky() const { return this->Sky ? this->Sky->Kind : SkyKind::Uniform; }
};

/// The irradiance of the sun: the given one, or that of the sun of a Perez sky, or 1.
std::array<double, 3> SunIrradianceOf(const LightDescription& lights);

} // namespace skyline

#endif
