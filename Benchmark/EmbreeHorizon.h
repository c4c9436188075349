// SPDX-License-Identifier: BSD-3-Clause
// The peer: horizons by an Embree ray caster, measured.
#ifndef skyline_EmbreeHorizon_h
#define skyline_EmbreeHorizon_h

#include "Result.h"
#include "Truth.h"

#include <string>

namespace skyline
{
namespace benchmark
{

/// "3.13.5", or "not built in" where Embree was not found.
std::string EmbreeVersion();

/// Errors on the posts of the truth; times on runs of adjacent posts, whose rays share caches as
/// those of a whole raster do, all azimuths of a post in turn. accuracy: degrees by which a horizon
/// may be off. Search: occlusion rays only, a bracket grown from the horizon of the azimuth before,
/// as HORAYZON (Steger, Steger and Schaer 2022) starts, and halved until it is two accuracies wide.
/// std::runtime_error("not built in") without Embree.
Result MeasureEmbree(const Scene& scene, const Truth& truth, double accuracy, int repeats);

} // namespace benchmark
} // namespace skyline

#endif
