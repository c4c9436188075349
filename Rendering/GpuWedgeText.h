// SPDX-License-Identifier: BSD-3-Clause
// The shaders of GpuHarmonics: text for the coefficients that are wanted.
#ifndef skyline_GpuWedgeText_h
#define skyline_GpuWedgeText_h

#include <string>

namespace skyline
{

constexpr int CoefficientsPerImage = 4;
constexpr int ImagesPerPass = 8; // OpenGL 3.2 has as many outputs

/// Sums the coefficients [begin, end) of visibility or transfer, at most 32, over four azimuths, by
/// the integrals of ElevationIntegral.h. Sampler and uniforms: GpuWedges.glsl.
std::string WedgeText(int bands, bool transfer, int begin, int end);

/// Irradiance from `imageCount` images of coefficients and a light's: GpuLight.glsl.
std::string LightText(int imageCount);

} // namespace skyline

#endif
