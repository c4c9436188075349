// SPDX-License-Identifier: BSD-3-Clause
// The lights that the user asked for.
#ifndef skyline_Lights_h
#define skyline_Lights_h

#include "Options.h"
#include "SkyNames.h"
#include "SunLight.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <CLI/CLI.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkSkylineLight;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// --environment, --rotation, --time, --sun, --sun-irradiance, --lamp ...
struct LightOptions
{
  std::string Environment;
  double Rotation = 0.0; ///< degrees
  SunOptions Sun;
  std::string SunIrradiance;
  std::vector<std::string> Lamps;
  void AddTo(CLI::App& command);

  /// --rotation, --sun-irradiance and --lamp alone.
  void AddLampsTo(CLI::App& command, bool picture = true);

  /// Throws WrongUsage for options that cannot act under a sky of this kind; before any work. `sunShines`:
  /// a sun is among the lights; `keyLight`: a wide one is a key light, which has no limb.
  void RefuseIdle(const IdleOptions& options, SkyKind kind, bool sunShines, bool keyLight) const;

  /// Warns where --rotation parts a sky from its sun.
  void WarnOfTurnedSky(SkyKind kind, const Talk& talk) const;
};

/// Irradiance on a plane that faces the sun, of an --sun-irradiance; none: not given.
std::optional<std::array<double, 3>> AskedSunIrradiance(const LightOptions& options);

/// Discs beyond this radius, degrees, are key lights: their parts have different cosines.
constexpr double LargestSun = 3.0;

/// The lights over a terrain; a uniform sky if the user asked for none. Reads the light map, told as
/// a pass. Throws Failure with a one-line reason.
std::vector<vtkSmartPointer<vtkSkylineLight>> MakeLights(
  const LightOptions& options, vtkImageData* terrain, const Talk& talk);

} // namespace skyline

#endif
