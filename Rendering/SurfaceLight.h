// SPDX-License-Identifier: BSD-3-Clause
// Distant light in the form that the fragment shaders of vtkSkylineSoftShadowShader need.
#ifndef skyline_SurfaceLight_h
#define skyline_SurfaceLight_h

#include "Harmonics/SphericalHarmonics.h"

#include <array>
#include <cstddef>
#include <vector>

namespace skyline
{

constexpr std::size_t LightCoefficients = HarmonicCount(DefaultHarmonicBands);

/// The functions of the bands 0 to 2: below band 4, a clamped cosine has no others.
constexpr std::size_t CosineShapes = 9;

using LightColor = std::array<double, 3>; ///< red, green, blue

/// The radiance of a light as spherical harmonics.
using SurfaceLight = std::array<LightColor, LightCoefficients>;

/// For Transfer.glsl: the coefficients of red, of green and of blue.
std::vector<float> PackTransferLight(const SurfaceLight& light);

/// For Visibility.glsl: the product of the light with each function of the cosine (Snyder &
/// Nowrouzezahrai 2008, section 4).
std::vector<float> PackVisibilityLight(const SurfaceLight& light);

/// For Receiver.glsl: the irradiance from the whole sky, for each function of the normal.
std::array<LightColor, CosineShapes> OpenSky(const SurfaceLight& light);

} // namespace skyline

#endif
