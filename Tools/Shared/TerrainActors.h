// SPDX-License-Identifier: BSD-3-Clause
// The terrain as something to look at: a mesh, the block under it, and the sky behind.
#ifndef skyline_TerrainActors_h
#define skyline_TerrainActors_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkAlgorithm;
class vtkHeightFieldSurface;
class vtkImageData;
class vtkMapper;
class vtkPolyData;
class vtkRenderer;
class vtkSkylineSoftShadowPolyDataMapper;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Posts of a mesh, which larger terrain thins out; the light keeps its resolution.
constexpr double MostMeshPosts = 4.0e6;

/// The sRGB code of the factor on the light of the block's rim.
constexpr double SkirtColor = 0.6;

/// The triangles of the terrain (the point array Elevation), thinned out to so many posts; not updated.
vtkSmartPointer<vtkHeightFieldSurface> MakeMesh(vtkImageData* terrain, double posts);

/// The walls of the block under that mesh; not updated.
vtkSmartPointer<vtkHeightFieldSurface> MakeSkirt(
  vtkImageData* terrain, double posts, vtkPolyData* mesh);

/// Draws the point array Radiance of a lit terrain, at an exposure in stops.
vtkSmartPointer<vtkSkylineSoftShadowPolyDataMapper> MakeMapper(
  vtkAlgorithm* mesh, vtkImageData* terrain, double exposure);

/// vtkSkylineSoftShadowShader's exposure for radiance: that is light times colour over pi already.
double ShaderExposure(double exposure);

vtkSmartPointer<vtkActor> MakeActor(vtkMapper* mapper, double color);

/// The sky behind the terrain, from the picture's lower to its upper edge: that of the light, paler
/// and brighter towards the horizon.
void PaintSky(vtkRenderer* renderer, const std::array<float, 3>& radiance, double exposure);

} // namespace skyline

#endif
