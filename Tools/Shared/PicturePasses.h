// SPDX-License-Identifier: BSD-3-Clause
// The passes that light a terrain for a picture. The command shade runs them once, the window
// repeatedly.
#ifndef skyline_PicturePasses_h
#define skyline_PicturePasses_h

#include "Color/Daylight.h"
#include "Options.h"
#include "Sky/SkyDescription.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <optional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkHeightFieldAlgorithm;
class vtkHeightFieldIrradiance;
class vtkHeightFieldShading;
class vtkHeightFieldSunShadow;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Updates an algorithm as the pass with the given name.
using RunFunction = std::function<void(vtkAlgorithm*, const std::string&)>;

/// The heights multiplied by `factor`, for light and shadow alike; the same image if the factor is
/// 1.
vtkSmartPointer<vtkImageData> Exaggerate(
  vtkImageData* heights, double factor, const RunFunction& run);

/// Returns whether the light of a sky is an array of MakeSkyPass, times the radiance of the sky.
/// Other skies, except a black one, are environments of MakeIrradiancePass.
bool HasSkyPass(SkyKind kind);
bool HasEnvironment(SkyKind kind);

/// How much light of a uniform or zonal sky each post gets, and the name of the array for it.
struct SkyPass
{
  vtkSmartPointer<vtkHeightFieldAlgorithm> Filter;
  const char* Array;
};
SkyPass MakeSkyPass(
  const SkyDescription& sky, vtkImageData* terrain, const HorizonOptions& horizon);

///@{
/// Makes the pass for environments, lamps and measured suns, and the one for shadows of the sun.
/// The caller adds the lights.
vtkSmartPointer<vtkHeightFieldIrradiance> MakeIrradiancePass(
  vtkImageData* terrain, const HorizonOptions& horizon);
vtkSmartPointer<vtkHeightFieldSunShadow> MakeShadowPass(
  vtkImageData* terrain, const HorizonOptions& horizon);
///@}

/// Returns whether the sun of that day gives any light.
bool SunShines(const Daylight& day);

/// Replaces the irradiance of the sun by that of the user, if one is given and the sun is up.
void ReplaceSun(const std::optional<std::array<double, 3>>& asked, Daylight& day);

/// Sets the sun and the sky of a picture.
void SetDaylight(const Daylight& day, vtkHeightFieldShading* shading);

} // namespace skyline

#endif
