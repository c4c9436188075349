// SPDX-License-Identifier: BSD-3-Clause
// Distant light as the fragment shaders of vtkSkylineSoftShadowShader take it.
#ifndef skyline_SurfaceLight_h
#define skyline_SurfaceLight_h

#include "Harmonics/SphericalHarmonics.h"

#include <array>
#include <cstddef>
#include <vector>

namespace skyline
{

constexpr std::size_t LightCoefficients = HarmonicCount(DefaultHarmonicBands);

/// Functions of the bands 0 to 2, the ones a clamped cosine has below band 4.
constexpr std::size_t CosineShapes = 9;

using LightColor = std::array<double, 3>; ///< red, green, blue

/// Radiance as spherical harmonics.
using SurfaceLight = std::array<LightColor, LightCoefficients>;

/// For Transfer.glsl: the coefficients of red, of green, of blue.
std::vector<float> PackTransferLight(const SurfaceLight& light);

/// For Visibility.glsl: the product of the light with each function of the cosine (SN08, section 4).
std::vector<float> PackVisibilityLight(const SurfaceLight& light);

/// For Receiver.glsl: what the whole sky gives, for each function of the normal.
std::array<LightColor, CosineShapes> OpenSky(const SurfaceLight& light);

} // namespace skyline

#endif
