// SPDX-License-Identifier: BSD-3-Clause
// The light of lamps on each post: by direct integration, and by harmonics as in THESIS.
#ifndef skyline_LampShading_h
#define skyline_LampShading_h

#include "KeyShading.h"
#include "Reference/LampHarmonics.h"

#include <array>
#include <vector>

namespace skyline
{
namespace gallery
{

/// A lamp and its radiance, linear RGB.
struct ColoredLamp
{
  oracle::Ball Ball;
  std::array<float, 3> Radiance;
};

/// RGB per post, the sum over the lamps.
std::vector<float> DirectLamps(const Scene& scene, const std::vector<ColoredLamp>& lamps);

/// The same by harmonics of order 4, as the product of three truncated series of the thesis.
/// levelStep: that of the pyramid for the horizons in front of the lamp, with the level offset 4 of
/// THESIS; 0: exact horizons.
std::vector<float> HarmonicLamps(
  const Scene& scene, const std::vector<ColoredLamp>& lamps, int azimuths, double levelStep);

/// The luminance of each post.
std::vector<float> LuminanceOf(const std::vector<float>& rgb);

} // namespace gallery
} // namespace skyline

#endif
