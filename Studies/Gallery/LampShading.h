// SPDX-License-Identifier: BSD-3-Clause
// The light of lamps on every post: by direct integration, and by harmonics as THESIS has it.
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

/// RGB a post, summed over the lamps.
std::vector<float> DirectLamps(const Scene& scene, const std::vector<ColoredLamp>& lamps);

/// Likewise in order 4. levelStep: of the pyramid for the horizons in front of the lamp, at THESIS's
/// level offset of 4; 0: exact horizons. The product is the thesis's, of three truncated series.
std::vector<float> HarmonicLamps(
  const Scene& scene, const std::vector<ColoredLamp>& lamps, int azimuths, double levelStep);

/// Luminance of every post.
std::vector<float> LuminanceOf(const std::vector<float>& rgb);

} // namespace gallery
} // namespace skyline

#endif
