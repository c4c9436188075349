// SPDX-License-Identifier: BSD-3-Clause
// A light map as a vtkImageData.
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

/// The point scalars of a light map: three floats, linear RGB radiance.
constexpr const char* RadianceArrayName = "Radiance";

/// The kernels' view of an image with such scalars, row 0 of the image at the bottom (the nadir):
/// valid while the image keeps them. The image is two-dimensional, with the scalars "Radiance" as
/// vtkSkylineLightMapReader makes them, else std::invalid_argument with a one-line reason. The values are
/// taken as they are: finite and not negative from the reader; others are mended first
/// (SanitizeLightMap).
SKYLINECORE_EXPORT LightMap ViewLightMap(vtkImageData* image);

} // namespace skyline

#endif
