// SPDX-License-Identifier: BSD-3-Clause
// Colours of sun and sky for a picture. Pure functions, no VTK.
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
  Rgb SunIrradiance; ///< on a surface that faces the sun
  Rgb SkyRadiance;   ///< of every part of a uniform sky
};

/// Sun and sky for an apparent sun elevation in degrees. The sun's colour is that of white light
/// after Rayleigh's air and a light haze (optical depths 0.0088 l^-4.08 and 0.05 l^-1.3 at
/// wavelengths l of 0.61, 0.55 and 0.465 micrometres). The sky is pale blue; its strength is set
/// for legible shadows (a fifth of the light on level ground at 45 degrees), not measured. White
/// balance and scale are those of a camera set for level open ground, which gets irradiance pi in
/// luminance and keeps a quarter of the cast. Without air the sun is white and the sky grey.
inline Daylight ClearDaylight(double elevation, bool air = true)
{
  const double height = std::sin(std::clamp(elevation, 0.0, 90.0) * RadiansPerDegree);
  const bool up = elevation > -0.9; // below that not even the upper limb rises over level ground
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
