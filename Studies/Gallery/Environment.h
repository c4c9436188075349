// SPDX-License-Identifier: BSD-3-Clause
// A sky at dusk around a scene.
#ifndef skyline_Environment_h
#define skyline_Environment_h

#include "KeyShading.h"

#include <functional>
#include <vector>

namespace skyline
{
namespace gallery
{

/// Blue above, a warm glow low in the west: a light map that gives level open ground an irradiance of
/// `brightness` (luminance).
class Environment
{
public:
  explicit Environment(double brightness);

  /// RGB a post from 96 azimuths of exact horizons, each row of the map integrated in closed form.
  std::vector<float> Direct(const Scene& scene) const;

  /// RGB a post as SN08 and THESIS have it: visibility of 32 azimuths of the given horizons in wedges,
  /// projected light, products of order 4.
  std::vector<float> Published(const Scene& scene, const HorizonsAt& horizons) const;

  /// RGB a post as Skyline has it: 32 exact horizons, TransferSH, light fitted above the horizon.
  std::vector<float> Transferred(const Scene& scene) const;

private:
  /// Shades colour by colour, the light projected.
  std::vector<float> Series(
    const Scene& scene, const std::function<std::vector<float>(const Light16&)>& shade) const;

  std::vector<float> Pixels;
};

} // namespace gallery
} // namespace skyline

#endif
