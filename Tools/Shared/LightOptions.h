// SPDX-License-Identifier: BSD-3-Clause
// The options that name lights: --environment, --rotation, --time, --sun, --sun-irradiance, --lamp ...
// The text of each is read once, into the description of the lights.
#ifndef skyline_LightOptions_h
#define skyline_LightOptions_h

#include "LightDescription.h"
#include "Passes.h"

#include <CLI/CLI.hpp>

namespace skyline
{

class IdleOptions;

///@{
/// Adds --time, --sun, --sun-radius, --limb-darkening, which are read into `sun`.
void AddSunOptions(CLI::App& command, SunDescription& sun, bool limbDarkening = true);

/// Throws WrongUsage for options that cannot act with this sun; before any work.
void RefuseIdleSun(const SunDescription& sun, const IdleOptions& options);

/// Warns where the time has no zone.
void WarnOfZone(const SunDescription& sun, const Talk& talk);
///@}

///@{
/// Adds the options of all lights, which are read into `lights`: all of them; --environment of a picture,
/// with a uniform sky as the default; --rotation, --sun-irradiance and --lamp alone.
void AddLightOptions(CLI::App& command, LightDescription& lights);
void AddPictureSkyOption(CLI::App& command, LightDescription& lights);
void AddLampOptions(CLI::App& command, LightDescription& lights, bool picture = true);

/// Throws WrongUsage for options that cannot act under a sky of this kind; before any work. `sunShines`:
/// a sun is among the lights; `keyLight`: a wide one is a key light, which has no limb.
void RefuseIdleLights(const LightDescription& lights, const IdleOptions& options, SkyKind kind,
  bool sunShines, bool keyLight);

/// Warns where --rotation parts a sky of this kind from its sun.
void WarnOfTurnedSky(const LightDescription& lights, SkyKind kind, const Talk& talk);
///@}

} // namespace skyline

#endif
