// SPDX-License-Identifier: BSD-3-Clause
// The commands of the program; each adds itself, its options and its work.
#ifndef skyline_Commands_h
#define skyline_Commands_h

#include <CLI/CLI.hpp>

namespace skyline
{

void AddHorizon(CLI::App& program);      ///< the horizon of every post, one band an azimuth
void AddSkyView(CLI::App& program);      ///< how much sky every post sees, one band a quantity
void AddSun(CLI::App& program);          ///< where the sun is, and which posts it reaches
void AddShadowHeight(CLI::App& program); ///< how high the shadow of the terrain stands
void AddIrradiance(CLI::App& program);   ///< the light on every post, three bands
void AddShade(CLI::App& program);        ///< a picture of the lit terrain
void AddBenchmark(CLI::App& program);    ///< error against run time of every method, as a page
void AddView(CLI::App& program);         ///< a window on the lit terrain

} // namespace skyline

#endif
