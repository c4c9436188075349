// SPDX-License-Identifier: BSD-3-Clause
// Finds where a line of sight meets the terrain.
#ifndef skyline_HeightRay_h
#define skyline_HeightRay_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

using ScenePoint = std::array<double, 3>; ///< image coordinates, metres; heights exaggerated

/// The height of the ground at a place, bilinear between posts, times the exaggeration. NaN outside
/// the field and in cells with a missing post.
double GroundAt(vtkImageData* terrain, double exaggeration, double x, double y);

/// The same, with 0 instead of NaN.
double GroundOrZero(vtkImageData* terrain, double exaggeration, double x, double y);

/// Finds the first place where the way from `from` to `to` goes below the ground, to 0.01 post
/// spacings. Returns false if there is none. The way is sampled twice per post, so a narrow peak
/// may be missed.
bool FindGround(vtkImageData* terrain, double exaggeration, const ScenePoint& from,
  const ScenePoint& to, ScenePoint& found);

} // namespace skyline

#endif
