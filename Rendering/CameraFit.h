// SPDX-License-Identifier: BSD-3-Clause
// Where to stand so that everything is in the picture.
#ifndef skyline_CameraFit_h
#define skyline_CameraFit_h

#include "SkylineRenderingModule.h" // For the export macro
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkPoints;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Directions in degrees.
struct Standpoint
{
  double Azimuth = 180.0;  ///< from the terrain to the viewer, clockwise from north
  double Elevation = 35.0; ///< of the viewer, above 0 (on the ground) to 90 (straight above)
  double ViewAngle = 30.0; ///< of the picture's height
  double Aspect = 1.6;     ///< the picture's width over its height
  double Filled = 0.94;    ///< the part of width or height that the points may fill
};

/// Moves the camera as near as the points allow: all lie within the filled part of the picture, and
/// touch two opposite sides of it. In the plane of either side, a point at the depth w and the
/// offset u is in sight from a camera at the offset c and the depth -d where |u - c| <= t (w + d),
/// t the tangent of half the angle. So d >= max(u - t w) / 2t + max(-u - t w) / 2t, and there c is
/// half the difference of the two maxima. No points: nothing changes.
SKYLINERENDERING_EXPORT void FitCamera(
  vtkCamera* camera, const std::vector<vtkPoints*>& points, const Standpoint& standpoint);

} // namespace skyline

#endif
