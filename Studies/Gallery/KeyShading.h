// SPDX-License-Identifier: BSD-3-Clause
// Light from afar on every post: as Snyder & Nowrouzezahrai 2008 (SN08) publish it, as Skyline's filters
// do, and by direct integration. Elevations and azimuths in radians.
#ifndef skyline_KeyShading_h
#define skyline_KeyShading_h

#include "Harmonics/KeyLight.h"
#include "Horizon/HorizonMethod.h"
#include "Reference/LampScene.h"

#include <array>
#include <functional>
#include <vector>

namespace skyline
{
namespace gallery
{

using Scene = testing::LampScene;

/// Order 4 throughout, as in the paper.
using Light16 = std::array<double, 16>;

/// Elevations of the horizons of all posts in an azimuth, 0 or more.
using HorizonsAt = std::function<std::vector<float>(double azimuth)>;

HorizonsAt HorizonsOf(const Scene& scene, const HorizonSettings& settings);
HorizonsAt ExactHorizons(const Scene& scene);
HorizonsAt PyramidHorizons(
  const Scene& scene, double levelStep, double levelOffset, bool spline = true);

/// SN08's total visibility, 16 coefficients a post: wedges with linear horizons from its tables, and
/// at the ends of a partial swath the boundary wedges.
std::vector<float> PublishedVisibility(
  std::size_t posts, const HorizonsAt& horizons, const Swath& swath, int azimuths);

/// SN08's shading: the product of the truncated series of visibility and clamped cosine, times the
/// light. Not cut off at 0.
std::vector<float> PublishedShading(
  const Scene& scene, const std::vector<float>& visibility, const Light16& light);

/// The light scaled until what PublishedShading makes of it is at most 1 in the open, over all
/// normals in the vertical plane through the swath's middle.
Light16 PublishedUnit(const Light16& light, const Swath& swath, int azimuths);

/// Irradiance with visibility times cosine integrated (TransferSH). For a light that is its own
/// series this is direct integration, up to the number of azimuths.
std::vector<float> TransferShading(const Scene& scene, const HorizonsAt& horizons,
  const Swath& swath, int azimuths, const Light16& light);

/// The light scaled likewise for TransferShading.
Light16 TransferUnit(const Light16& light, const Swath& swath);

/// Irradiance of a key light of radiance 1 by integration over its disc above exact horizons.
std::vector<float> DirectShading(const Scene& scene, const KeyLight& light, int azimuths);

/// The light with all its energy in one direction, as far as order 4 can: SN08's "peakiest".
Light16 PeakLight(double azimuth, double elevation);

} // namespace gallery
} // namespace skyline

#endif
