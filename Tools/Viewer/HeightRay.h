// SPDX-License-Identifier: BSD-3-Clause
// Where a line of sight meets the terrain.
#ifndef skyline_HeightRay_h
#define skyline_HeightRay_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

using ScenePoint = std::array<double, 3>; ///< the image's coordinates, metres, heights exaggerated

/// Height of the ground at a place, bilinear between posts, times the exaggeration; NaN beside the
/// field and where a post of the cell is missing.
double GroundAt(vtkImageData* terrain, double exaggeration, double x, double y);

/// The same, 0 in place of NaN.
double GroundOrZero(vtkImageData* terrain, double exaggeration, double x, double y);

/// The first place where the way from `from` to `to` goes under the ground, to a hundredth of a post
/// spacing; false if there is none. The way is sampled twice a post: a sharper needle may be missed.
bool FindGround(vtkImageData* terrain, double exaggeration, const ScenePoint& from,
  const ScenePoint& to, ScenePoint& found);

} // namespace skyline

#endif
