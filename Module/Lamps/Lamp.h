// SPDX-License-Identifier: BSD-3-Clause
// A spherical lamp, and what it gives to a receiver with nothing between them.
#ifndef skyline_Lamp_h
#define skyline_Lamp_h

#include "SkylineCoreModule.h" // for the export macro

#include <array>

namespace skyline
{

/// A glowing ball over, on or under the ground. X and Y are metres east and north of the post
/// (0, 0), on the grid that the receivers are on: column * SpacingX, row * SpacingY. Z is metres
/// above the height field's base, the one given to HeightField::Fill.
struct Lamp
{
  double X = 0.0, Y = 0.0, Z = 0.0;
  double Radius = 0.0;                               ///< metres, 0 (no light) or more
  std::array<float, 3> Radiance{ 1.0f, 1.0f, 1.0f }; ///< RGB, of every point to every side
};

/// std::invalid_argument with a one-line reason if a number is not finite or the radius or a
/// radiance is below 0.
SKYLINECORE_EXPORT void CheckLamp(const Lamp& lamp);

/// The lamp as a receiver sees it: a disc on its sphere of directions.
///
/// From outside (distance d >= radius r) its angular radius is asin(r / d). A receiver inside sees
/// light from everywhere but a disc of angular radius asin(d / r) opposite to the lamp's centre: the
/// two meet on the lamp's skin, where half of all directions glow, and at the centre nothing is
/// dark. So the light changes continuously on the way in.
struct LampDisc
{
  double Sine = 0.0;   ///< of the angular radius
  double Cosine = 1.0; ///< below 0 inside the lamp
};
SKYLINECORE_EXPORT LampDisc DiscOfLamp(double radius, double distance);

/// The irradiance of an element from a disc of unit radiance whose centre lies at an angle with this
/// cosine (-1 to 1) to the normal: the integral of max(0, n.d) over the disc, exactly, whether the
/// element's plane cuts it or not. 0 to pi.
///
/// The disc of angular radius s at the angle t, y = -cot s cot t, in the cut case:
///   sin^2 s (cos t acos y - cot s sin t sqrt(1 - y^2)) + atan(tan s sin t sqrt(1 - y^2))
/// (configuration factor of a sphere to a tilted element; derived in Documentation/lamps.md).
SKYLINECORE_EXPORT double DiscIrradiance(const LampDisc& disc, double cosine);

} // namespace skyline

#endif
