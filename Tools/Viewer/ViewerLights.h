// SPDX-License-Identifier: BSD-3-Clause
// From what the user asked for and has set to the light on the terrain.
#ifndef skyline_ViewerLights_h
#define skyline_ViewerLights_h

#include "Files.h"
#include "LightDescription.h"
#include "LitTerrain.h"
#include "ViewerState.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <map>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkSkylineEnvironmentLight;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// The lights of the command line, and the skies met since. Light maps are read once.
class ViewerLights
{
public:
  ViewerLights(const LightDescription& asked, const Talk& talk);

  /// The place of the lights; first of all. Throws what CenterOf throws.
  void SetTerrain(vtkImageData* terrain);

  /// The calendar of that place; without one on the Earth the sun stays where it is.
  void SetClock(ViewerState& state) const;

  /// Sun, skies and lamps of the command line. Throws Failure.
  void Take(ViewerState& state);

  /// The light of a sky that is not the same all around; null for the others. Throws Failure for a
  /// map that cannot be read.
  vtkSmartPointer<vtkSkylineEnvironmentLight> Find(const SkyDescription& sky);
  void Forget(const std::string& name);

  /// The light as the state has it. Throws what FindSun and Find throw.
  TerrainLight Make(const ViewerState& state);

  /// A text that differs where the light does, but for the exaggeration.
  static std::string Key(const ViewerState& state);

private:
  LightDescription Asked;
  Talk Told;
  vtkSmartPointer<vtkImageData> Terrain;
  Center Middle;
  std::map<std::string, vtkSmartPointer<vtkSkylineEnvironmentLight>> Environments;
  Rgb MeasuredSun{ { 1, 1, 1 } };
};

} // namespace skyline

#endif
