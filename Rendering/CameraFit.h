// SPDX-License-Identifier: BSD-3-Clause
// Where the camera must stand so that all points are in the picture.
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

/// The direction of the view, in degrees, and the shape of the picture.
struct Standpoint
{
  double Azimuth = 180.0;  ///< from the terrain to the viewer, clockwise from north
  double Elevation = 35.0; ///< of the viewer, above 0 (at the ground) to 90 (vertically above)
  double ViewAngle = 30.0; ///< degrees that the height of the picture covers
  double Aspect = 1.6;     ///< width of the picture divided by its height
  double Filled = 0.94;    ///< part of the width or height that the points may fill
};

/// Moves the camera as close as the points allow: all points lie within the filled part of the
/// picture and touch two opposite sides of it.
/// In the plane of each pair of sides, a camera at the offset c and the depth -d sees a point at
/// the depth w and the offset u if |u - c| <= t (w + d), where t is the tangent of half the view
/// angle.
/// Therefore d >= max(u - t w) / 2t + max(-u - t w) / 2t, and at the least d the offset c is half
/// the difference of the two maxima. Without points the camera does not change.
SKYLINERENDERING_EXPORT void FitCamera(
  vtkCamera* camera, const std::vector<vtkPoints*>& points, const Standpoint& standpoint);

} // namespace skyline

#endif
