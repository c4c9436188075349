// SPDX-License-Identifier: BSD-3-Clause
// Colours of the sun and the sky for a picture. Pure functions, without VTK.
#ifndef skyline_Daylight_h
#define skyline_Daylight_h

#include "Color/ToneMap.h"
#include "Shared/Constants.h"
#include "Sky/AirMass.h"

#include <array>
#include <cmath>

namespace skyline
{

/// The lights of an outdoor picture.
struct Daylight
{
  Rgb SunIrradiance; ///< of the sun, on a surface that faces it
  Rgb SkyRadiance;   ///< of a uniform sky
};

/// Light of the sun and the sky for an apparent elevation of the sun in degrees. The colour of the
/// sun is white light that has passed through air (Rayleigh scattering) and a light haze: optical
/// depths 0.0088 l^-4.08 and 0.05 l^-1.3 at the wavelengths l of 0.61, 0.55 and 0.465 micrometres.
/// The sky is pale blue. Its strength is not measured but chosen for legible shadows: a fifth of
/// the light on level ground at 45 degrees. Scale and white balance are those of a camera set for
/// level open ground: its irradiance has the luminance pi, and a quarter of the colour cast
/// remains. Without air the sun is white and the sky is grey.
inline Daylight ClearDaylight(double elevation, bool air = true)
{
  const double height = std::sin(std::clamp(elevation, 0.0, 90.0) * RadiansPerDegree);
  const bool up = elevation > -0.9; // below this, not even the upper limb rises above level ground
  const std::array<double, 3> wavelength{ { 0.61, 0.55, 0.465 } };
  const Rgb blue{ { 0.82f, 1.0f, 1.30f } };
  Daylight light{};
  Rgb ground{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double depth =
      0.0088 * std::pow(wavelength[c], -4.08) + 0.05 * std::pow(wavelength[c], -1.3);
    const double sun = !up ? 0.0 : air ? std::exp(-depth * AirMass(elevation)) : 0.8;
    const double sky = (0.005 + 0.13 * std::sqrt(height)) * (air ? blue[c] : 1.0f);
    light.SunIrradiance[c] = static_cast<float>(sun);
    light.SkyRadiance[c] = static_cast<float>(sky / Pi);
    ground[c] = static_cast<float>(sun * height + sky);
  }
  const float luminance = Luminance(ground);
  for (std::size_t c = 0; c < 3; ++c)
  {
    const float balance =
      std::pow(ground[c] / luminance, 0.75f) * luminance / static_cast<float>(Pi);
    light.SunIrradiance[c] /= balance;
    light.SkyRadiance[c] /= balance;
  }
  return light;
}

} // namespace skyline

#endif
