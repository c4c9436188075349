// SPDX-License-Identifier: BSD-3-Clause
// Distant light on each post: by the published method of Snyder & Nowrouzezahrai (2008), SN08; by
// Skyline's filters; and by direct integration. Elevations and azimuths are in radians.
#ifndef skyline_KeyShading_h
#define skyline_KeyShading_h

#include "Horizon/HorizonMethod.h"
#include "Reference/KeyLight.h"
#include "Reference/LampScene.h"

#include <array>
#include <functional>
#include <vector>

namespace skyline
{
namespace gallery
{

using Scene = testing::LampScene;

/// The order is 4 everywhere, as in the paper.
using Light16 = std::array<double, 16>;

/// Returns the elevations of the horizons of all posts in an azimuth, 0 or more.
using HorizonsAt = std::function<std::vector<float>(double azimuth)>;

HorizonsAt HorizonsOf(const Scene& scene, const HorizonSettings& settings);
HorizonsAt ExactHorizons(const Scene& scene);
HorizonsAt PyramidHorizons(
  const Scene& scene, double levelStep, double levelOffset, bool spline = true);

/// The total visibility of SN08, 16 coefficients per post: wedges with linear horizons from the
/// tables of SN08, and the boundary wedges at the ends of a partial swath.
std::vector<float> PublishedVisibility(
  std::size_t posts, const HorizonsAt& horizons, const Swath& swath, int azimuths);

/// The shading of SN08: the product of the truncated series of visibility and of the clamped
/// cosine, times the light. It can be negative.
std::vector<float> PublishedShading(
  const Scene& scene, const std::vector<float>& visibility, const Light16& light);

/// Scales the light so that the result of PublishedShading without terrain is at most 1, for all
/// normals in the vertical plane through the middle of the swath.
Light16 PublishedUnit(const Light16& light, const Swath& swath, int azimuths);

/// The irradiance with the integral of visibility times cosine (TransferSH). If the light is equal
/// to its series, this is direct integration, up to the number of azimuths.
std::vector<float> TransferShading(const Scene& scene, const HorizonsAt& horizons,
  const Swath& swath, int azimuths, const Light16& light);

/// Scales the light for TransferShading in the same way.
Light16 TransferUnit(const Light16& light, const Swath& swath);

/// The irradiance from a key light with radiance 1, by integration over its disc above exact
/// horizons.
std::vector<float> DirectShading(const Scene& scene, const KeyLight& light, int azimuths);

/// A light whose energy is as concentrated in one direction as order 4 allows: the "peakiest" light
/// of SN08.
Light16 PeakLight(double azimuth, double elevation);

} // namespace gallery
} // namespace skyline

#endif
