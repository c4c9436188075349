// SPDX-License-Identifier: BSD-3-Clause
// The lights that the user asked for.
#ifndef skyline_Lights_h
#define skyline_Lights_h

#include "Options.h"
#include "SunLight.h"

#include "vtkSmartPointer.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

class vtkImageData;
class vtkSkylineLight;

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
  void AddLampsTo(CLI::App& command);
};

/// What is wrong with the text of an --environment; empty: nothing, or a file, which is met later.
std::string CheckEnvironment(std::string& name);

/// The lights over a terrain; a uniform sky if the user asked for none. Reads the light map, told as
/// a pass. Throws Failure with a one-line reason.
std::vector<vtkSmartPointer<vtkSkylineLight>> MakeLights(
  const LightOptions& options, vtkImageData* terrain, const Talk& talk);

} // namespace skyline

#endif
