// SPDX-License-Identifier: BSD-3-Clause
// VTK's light objects of the lights that somebody asked for.
#ifndef skyline_Lights_h
#define skyline_Lights_h

#include "LightDescription.h"
#include "Passes.h"

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

/// The lights over a terrain; a uniform sky if the user asked for none. Reads the light map, told as
/// a pass. Throws Failure with a one-line reason.
std::vector<vtkSmartPointer<vtkSkylineLight>> MakeLights(
  const LightDescription& lights, vtkImageData* terrain, const Talk& talk);

/// A sky alone, its sun and rotation still the default ones. Reads the light map, told as a pass. Throws
/// Failure with a one-line reason.
vtkSmartPointer<vtkSkylineEnvironmentLight> MakeSky(const SkyDescription& sky, const Talk& talk);

/// A lamp alone. Warns of one without light.
vtkSmartPointer<vtkSkylineLampLight> MakeLamp(
  const LampDescription& lamp, vtkImageData* terrain, const Talk& talk);

} // namespace skyline

#endif
