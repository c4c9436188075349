// SPDX-License-Identifier: BSD-3-Clause
// Makes VTK light objects from the description of the lights.
#ifndef skyline_Lights_h
#define skyline_Lights_h

#include "LightDescription.h"
#include "RunPass.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkSkylineEnvironmentLight;
class vtkSkylineLampLight;
class vtkSkylineLight;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// The lights over a terrain; a uniform sky if the user wants no light. Reads the light map, as a
/// pass. Throws Failure with a reason of one line.
std::vector<vtkSmartPointer<vtkSkylineLight>> MakeLights(
  const LightDescription& lights, vtkImageData* terrain, const CommonOptions& common);

/// A sky alone, with the default sun and rotation. Reads the light map, as a pass. Throws Failure
/// with a reason of one line.
vtkSmartPointer<vtkSkylineEnvironmentLight> MakeSky(
  const SkyDescription& sky, const CommonOptions& common);

/// A lamp alone. Warns if the lamp is black.
vtkSmartPointer<vtkSkylineLampLight> MakeLamp(
  const LampDescription& lamp, vtkImageData* terrain, const CommonOptions& common);

} // namespace skyline

#endif
