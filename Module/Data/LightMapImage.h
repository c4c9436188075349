// SPDX-License-Identifier: BSD-3-Clause
// A light map stored as vtkImageData.
#ifndef skyline_LightMapImage_h
#define skyline_LightMapImage_h

#include "Sky/LightMap.h"
#include "SkylineCoreModule.h"      // for the export macro
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Name of the point scalars of a light map: three floats of linear RGB radiance per pixel.
constexpr const char* RadianceArrayName = "Radiance";

/// A view of the image for the kernels, valid while the image keeps its scalars. Row 0 of the image
/// is the bottom row (the nadir). The image must be two-dimensional and have the scalars "Radiance"
/// of vtkSkylineLightMapReader; otherwise std::invalid_argument is thrown with a one-line reason.
/// The values are not checked: those of the reader are finite and not negative; others must be
/// cleaned first with SanitizeLightMap.
SKYLINECORE_EXPORT LightMap ViewLightMap(vtkImageData* image);

} // namespace skyline

#endif
