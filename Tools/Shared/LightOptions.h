// SPDX-License-Identifier: BSD-3-Clause
// The options for lights: --environment, --rotation, --time, --sun, --sun-irradiance, --lamp and
// others. The text of each is parsed once, into the description of the lights.
#ifndef skyline_LightOptions_h
#define skyline_LightOptions_h

#include "LightDescription.h"
#include "RunPass.h"

namespace CLI
{
class App;
}

namespace skyline
{

class UnusedOptions;

///@{
/// Adds --time, --sun, --sun-radius and --limb-darkening, which are parsed into `sun`.
void AddSunOptions(CLI::App& command, SunDescription& sun, bool limbDarkening = true);

/// Throws WrongUsage for options that have no effect with this sun. To be called before any work.
void RefuseUnusedSun(const SunDescription& sun, const UnusedOptions& options);

/// Warns if the time has no time zone.
void WarnOfZone(const SunDescription& sun, const CommonOptions& common);
///@}

///@{
/// Adds options that are parsed into `lights`: those of all lights; --environment of a picture,
/// with a uniform sky as the default; only --rotation, --sun-irradiance and --lamp.
void AddLightOptions(CLI::App& command, LightDescription& lights);
void AddPictureSkyOption(CLI::App& command, LightDescription& lights);
void AddLampOptions(CLI::App& command, LightDescription& lights, bool picture = true);

/// Throws WrongUsage for options that have no effect under a sky of this type. To be called before
/// any work. `sunShines`: a sun is among the lights. `keyLight`: a wide sun is a key light, which
/// has no limb.
void RefuseUnusedLights(const LightDescription& lights, const UnusedOptions& options, SkyKind kind,
  bool sunShines, bool keyLight);

/// Warns if --rotation turns a sky of this type away from its sun.
void WarnOfTurnedSky(const LightDescription& lights, SkyKind kind, const CommonOptions& common);
///@}

} // namespace skyline

#endif
