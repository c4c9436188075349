// SPDX-License-Identifier: BSD-3-Clause
// Computes the light of a lamp within milliseconds, while the user moves it.
#ifndef skyline_LampPreview_h
#define skyline_LampPreview_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFloatArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

struct ViewerLamp;

/// The light of lamps on one terrain: exact where nothing is in between (DiscIrradiance), with
/// approximate shadows.
///
/// One pass goes over rings of posts outwards from the lamp (XDRAW of Franklin and Ray, Higher
/// isn't necessarily better, SDH 1994). The greatest slope from the lamp on the way to a post is
/// interpolated between the two posts of the previous ring that the way passes; the share of the
/// lamp above it gives the penumbra. There are as many steps as posts. As always with XDRAW, the
/// edges of shadows widen and shift with distance.
class LampPreview
{
public:
  /// `terrain` has the point array Elevation, which is copied. Its spacing counts as metres.
  explicit LampPreview(vtkImageData* terrain);

  /// The irradiance (RGB) of each post by a lamp with its centre at the height `z`.
  vtkSmartPointer<vtkFloatArray> Light(const ViewerLamp& lamp, double z) const;

  /// The share of the lamp that each post sees, 0 to 1, hidden only by the terrain in between.
  std::vector<float> Visibility(const ViewerLamp& lamp, double z) const;

private:
  std::ptrdiff_t Columns, Rows;
  double Origin[2], Spacing[2];
  std::vector<float> Heights;
  std::vector<float> East, North; ///< slopes
};

} // namespace skyline

#endif
