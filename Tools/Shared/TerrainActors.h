// SPDX-License-Identifier: BSD-3-Clause
// The parts of a 3-D view of the terrain: a mesh, the block below it, and the sky behind it.
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

/// Greatest number of posts of a mesh. Larger terrain is thinned out; the light keeps its
/// resolution.
constexpr double MostMeshPosts = 4.0e6;

/// The factor on the light of the sides of the block, as an sRGB code.
constexpr double SkirtColor = 0.6;

/// The triangles of the terrain (the point array Elevation), thinned out to `posts` posts; not
/// updated.
vtkSmartPointer<vtkHeightFieldSurface> MakeMesh(vtkImageData* terrain, double posts);

/// The sides of the block below that mesh; not updated.
vtkSmartPointer<vtkHeightFieldSurface> MakeSkirt(
  vtkImageData* terrain, double posts, vtkPolyData* mesh);

/// Draws the point array Radiance of a lit terrain, at an exposure in stops.
vtkSmartPointer<vtkSkylineSoftShadowPolyDataMapper> MakeMapper(
  vtkAlgorithm* mesh, vtkImageData* terrain, double exposure);

/// The exposure of vtkSkylineSoftShadowShader for radiance, which already is light times colour /
/// pi.
double ShaderExposure(double exposure);

vtkSmartPointer<vtkActor> MakeActor(vtkMapper* mapper, double color);

/// Paints the sky behind the terrain, from the lower to the upper edge of the picture: the colour
/// of its light, paler and brighter towards the horizon.
void PaintSky(vtkRenderer* renderer, const std::array<float, 3>& radiance, double exposure);

} // namespace skyline

#endif
