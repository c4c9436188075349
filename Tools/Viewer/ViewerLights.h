// SPDX-License-Identifier: BSD-3-Clause
// Computes the light on the terrain from the options and the state of the viewer.
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

/// The lights of the command line, and the skies that were used since. Light maps are read once.
class ViewerLights
{
public:
  ViewerLights(const LightDescription& asked, const CommonOptions& common);

  /// Sets the place of the lights. To be called first. Throws the exceptions of CenterOf.
  void SetTerrain(vtkImageData* terrain);

  /// Sets the calendar for that place. Without a place on the Earth the sun does not move.
  void SetClock(ViewerState& state) const;

  /// Sets sun, skies and lamps of the command line. Throws Failure.
  void Take(ViewerState& state);

  /// The environment light of a sky that is not the same all around; null for other skies. Throws
  /// Failure if a light map cannot be read.
  vtkSmartPointer<vtkSkylineEnvironmentLight> Find(const SkyDescription& sky);
  void Forget(const std::string& name);

  /// The light for a state. Throws the exceptions of FindSun and Find.
  TerrainLight Make(const ViewerState& state);

  /// A text that differs whenever the light differs, apart from the exaggeration.
  static std::string Key(const ViewerState& state);

private:
  LightDescription Asked;
  CommonOptions Common;
  vtkSmartPointer<vtkImageData> Terrain;
  Center Middle;
  std::map<std::string, vtkSmartPointer<vtkSkylineEnvironmentLight>> Environments;
  Rgb MeasuredSun{ { 1, 1, 1 } };
};

} // namespace skyline

#endif
