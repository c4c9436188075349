// SPDX-License-Identifier: BSD-3-Clause
// The numbers that GpuHarmonics gives its shaders.
#ifndef skyline_GpuWedgeWeights_h
#define skyline_GpuWedgeWeights_h

#include <array>
#include <vector>

namespace skyline
{

/// The texels of GpuWedges.glsl for up to four azimuths (degrees), each of `width` radians; one that
/// is not there weighs nothing.
std::vector<float> WedgeTexels(int bands, const std::vector<double>& azimuths, double width);

/// What is there without any horizon, for the parts of the normal up, east and north: bands^2 sums
/// over the azimuths each.
std::array<std::vector<double>, 3> WholeSums(
  int bands, const std::vector<double>& azimuths, double width, bool transfer);

} // namespace skyline

#endif
