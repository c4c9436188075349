// SPDX-License-Identifier: BSD-3-Clause
// Measures the horizons of an Embree ray caster, for comparison.
#ifndef skyline_EmbreeHorizon_h
#define skyline_EmbreeHorizon_h

#include "ReferenceHorizons.h"
#include "Result.h"

#include <string>

namespace skyline
{
namespace benchmark
{

/// The version, such as "3.13.5", or "not built in" if Skyline was built without Embree.
std::string EmbreeVersion();

/// Errors are those at the posts of the reference. Times are measured on runs of adjacent posts,
/// whose rays share caches as those of a whole raster do, with all azimuths of a post in turn.
/// `accuracy`: the greatest error of a horizon in degrees. The search uses only occlusion rays: a
/// bracket starts at the horizon of the previous azimuth, as in HORAYZON (Steger, Steger and Schaer
/// 2022), grows, and is then halved until its width is twice the accuracy. Throws
/// std::runtime_error("not built in") without Embree.
Result MeasureEmbree(
  const Scene& scene, const ReferenceHorizons& truth, double accuracy, int repeats);

} // namespace benchmark
} // namespace skyline

#endif
