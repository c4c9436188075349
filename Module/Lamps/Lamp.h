// SPDX-License-Identifier: BSD-3-Clause
// A spherical lamp, and its irradiance on a receiver with nothing in between.
#ifndef skyline_Lamp_h
#define skyline_Lamp_h

#include "SkylineCoreModule.h" // for the export macro

#include <array>

namespace skyline
{

/// A glowing ball above, on or under the ground. X and Y are metres east and north of post (0, 0)
/// on the grid of the receivers: column * SpacingX and row * SpacingY. Z is metres above the base
/// of the height field, which was passed to HeightField::Fill.
struct Lamp
{
  double X = 0.0, Y = 0.0, Z = 0.0;
  double Radius = 0.0;                               ///< metres, 0 (no light) or more
  std::array<float, 3> Radiance{ 1.0f, 1.0f, 1.0f }; ///< RGB, the same from every point of the lamp
                                                     ///< in all directions
};

/// Throws std::invalid_argument with a one-line reason if a number is not finite, or if the radius
/// or a radiance is below 0.
SKYLINECORE_EXPORT void CheckLamp(const Lamp& lamp);

/// The lamp as a receiver sees it: a disc on the sphere of directions.
///
/// From outside (distance d >= radius r), its angular radius is asin(r / d). A receiver inside the
/// lamp sees light from all directions except a disc of angular radius asin(d / r) opposite to the
/// centre of the lamp. Both cases agree on the surface of the lamp, where half of all directions
/// glow; at the centre no direction is dark. The light therefore changes continuously.
struct LampDisc
{
  double Sine = 0.0;   ///< of the angular radius
  double Cosine = 1.0; ///< of the angular radius; below 0 inside the lamp
};
SKYLINECORE_EXPORT LampDisc DiscOfLamp(double radius, double distance);

/// The irradiance on a surface element from a disc of unit radiance whose centre lies at an angle
/// with this cosine (-1 to 1) to the normal: the integral of max(0, n.d) over the disc. The result,
/// 0 to pi, is exact even if the plane of the element cuts the disc.
///
/// The disc of angular radius s at the angle t, y = -cot s cot t, in the cut case:
///   sin^2 s (cos t acos y - cot s sin t sqrt(1 - y^2)) + atan(tan s sin t sqrt(1 - y^2))
/// (configuration factor of a sphere to a tilted element; derived in Documentation/lamps.md).
SKYLINECORE_EXPORT double DiscIrradiance(const LampDisc& disc, double cosine);

} // namespace skyline

#endif
