// SPDX-License-Identifier: BSD-3-Clause
// Measures r.horizon of GRASS GIS, if it is installed, for comparison.
#ifndef skyline_GrassHorizon_h
#define skyline_GrassHorizon_h

#include "ReferenceHorizons.h"
#include "Result.h"

#include <string>

namespace skyline
{
namespace benchmark
{

/// The version, such as "8.2.1", or "not installed".
std::string GrassVersion();

/// Runs r.horizon over the whole raster in a few azimuths that are not on the axes. The CPU time
/// includes reading and writing. The temporary location is removed afterwards. Throws
/// std::runtime_error("not installed") if GRASS is missing.
Result MeasureGrass(const Scene& scene, const ReferenceHorizons& truth, int azimuths);

} // namespace benchmark
} // namespace skyline

#endif
