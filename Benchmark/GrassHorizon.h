// SPDX-License-Identifier: BSD-3-Clause
// The peer: r.horizon of GRASS GIS, run as a program where it is installed.
#ifndef skyline_GrassHorizon_h
#define skyline_GrassHorizon_h

#include "Result.h"
#include "Truth.h"

#include <string>

namespace skyline
{
namespace benchmark
{

/// "8.2.1", or "not installed".
std::string GrassVersion();

/// r.horizon over the whole raster in a few azimuths off the axes, its CPU time with reading and
/// writing; in a temporary location of its own, removed afterwards.
/// std::runtime_error("not installed") where it is not.
Result MeasureGrass(const Scene& scene, const Truth& truth, int azimuths);

} // namespace benchmark
} // namespace skyline

#endif
