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

/// Blue at the top and a warm glow low in the west: a light map under which level open ground has
/// an irradiance of `brightness` (luminance).
class Environment
{
public:
  explicit Environment(double brightness);

  /// RGB per post, from 96 azimuths of exact horizons. Each row of the map is integrated in closed
  /// form.
  std::vector<float> Direct(const Scene& scene) const;

  /// RGB per post, by the method of SN08 and THESIS: the visibility in 32 azimuths of the given
  /// horizons as wedges, the projected light, and products of order 4.
  std::vector<float> Published(const Scene& scene, const HorizonsAt& horizons) const;

  /// RGB per post, by Skyline's method: 32 exact horizons, TransferSH, and light that is fitted
  /// above the horizon.
  std::vector<float> Transferred(const Scene& scene) const;

private:
  /// Shades the posts for one colour after the other, with the projected light.
  std::vector<float> Series(
    const Scene& scene, const std::function<std::vector<float>(const Light16&)>& shade) const;

  std::vector<float> Pixels;
};

} // namespace gallery
} // namespace skyline

#endif
