// SPDX-License-Identifier: BSD-3-Clause
// The numbers that GpuHarmonics passes to its shaders.
#ifndef skyline_GpuWedgeWeights_h
#define skyline_GpuWedgeWeights_h

#include <array>
#include <vector>

namespace skyline
{

/// The texels of GpuWedges.glsl for up to four azimuths (radians), whose swaths are `width` radians
/// wide. The weights of unused channels are 0.
std::vector<float> WedgeTexels(int bands, const std::vector<double>& azimuths, double width);

/// The sums without any horizon, for the upward, eastward and northward components of the normal:
/// bands^2 sums over the azimuths for each component.
std::array<std::vector<double>, 3> WholeSums(
  int bands, const std::vector<double>& azimuths, double width, bool transfer);

} // namespace skyline

#endif
