// SPDX-License-Identifier: BSD-3-Clause
// The shaders of GpuHarmonics, generated for the coefficients that are needed.
#ifndef skyline_GpuWedgeText_h
#define skyline_GpuWedgeText_h

#include <string>

namespace skyline
{

constexpr int CoefficientsPerImage = 4;
constexpr int ImagesPerPass = 8; // OpenGL 3.2 guarantees as many outputs

/// The shader that adds the coefficients [begin, end) of visibility or transfer, at most 32, for
/// four azimuths, from the integrals of ElevationIntegral.h. GpuWedges.glsl describes its samplers
/// and uniforms.
std::string WedgeText(int bands, bool transfer, int begin, int end);

/// The shader that computes irradiance from `imageCount` images of coefficients and those of a
/// light: see GpuLight.glsl.
std::string LightText(int imageCount);

} // namespace skyline

#endif
