// SPDX-License-Identifier: BSD-3-Clause
// The commands of the program. Each function adds one command with its options to the program.
#ifndef skyline_Commands_h
#define skyline_Commands_h

#include "UnusedOptions.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace skyline
{

void AddHorizon(CLI::App& program);      ///< horizon of each post, one band per azimuth
void AddSkyView(CLI::App& program);      ///< visible sky of each post, one band per quantity
void AddSun(CLI::App& program);          ///< position of the sun, and the posts that it reaches
void AddShadowHeight(CLI::App& program); ///< how high the shadow of the terrain reaches
void AddIrradiance(CLI::App& program);   ///< light on each post, three bands
void AddShade(CLI::App& program);        ///< a picture of the lit terrain
void AddBenchmark(CLI::App& program);    ///< error against run time of each method, as a page
void AddView(CLI::App& program);         ///< a window with the lit terrain

/// Makes the command refuse unused options and then run, once it is parsed. T has
/// Check(const UnusedOptions&) and Run().
template <typename T>
void RunAfterCheck(CLI::App& app, const std::shared_ptr<T>& command)
{
  app.callback(
    [&app, command]
    {
      command->Check(UnusedOptions(app));
      command->Run();
    });
}

} // namespace skyline

#endif
