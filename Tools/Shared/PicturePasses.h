// SPDX-License-Identifier: BSD-3-Clause
// The passes that light a terrain for a picture: shade runs them once, the window again and again.
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

/// Updates an algorithm as the pass of a name.
using RunFunction = std::function<void(vtkAlgorithm*, const std::string&)>;

/// The heights times `factor`, which light and shadow then see; the same image where that is 1.
vtkSmartPointer<vtkImageData> Exaggerate(
  vtkImageData* heights, double factor, const RunFunction& run);

/// Whether the light of a sky is an array of MakeSkyPass times the sky's radiance; others, but for a black
/// one, are environments of MakeIrradiancePass.
bool HasSkyPass(SkyKind kind);
bool HasEnvironment(SkyKind kind);

/// How much light of a uniform or zonal sky each post gets, and the name of the array that says it.
struct SkyPass
{
  vtkSmartPointer<vtkHeightFieldAlgorithm> Filter;
  const char* Array;
};
SkyPass MakeSkyPass(
  const SkyDescription& sky, vtkImageData* terrain, const HorizonOptions& horizon);

///@{
/// Light of environments, lamps and measured suns; shadows of the sun. The lights are still to be set.
vtkSmartPointer<vtkHeightFieldIrradiance> MakeIrradiancePass(
  vtkImageData* terrain, const HorizonOptions& horizon);
vtkSmartPointer<vtkHeightFieldSunShadow> MakeShadowPass(
  vtkImageData* terrain, const HorizonOptions& horizon);
///@}

/// Whether the sun of that day gives any light.
bool SunShines(const Daylight& day);

/// The sun's own irradiance, if one is asked for, in place of that of a day whose sun is up.
void ReplaceSun(const std::optional<std::array<double, 3>>& asked, Daylight& day);

/// Sun and sky of a picture.
void SetDaylight(const Daylight& day, vtkHeightFieldShading* shading);

} // namespace skyline

#endif
