// SPDX-License-Identifier: BSD-3-Clause
// A lamp's light within milliseconds, for as long as a hand moves it.
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

/// Lamps on one terrain: exact where nothing is between (DiscIrradiance), with approximate shadows.
///
/// One pass of rings of posts outwards from the lamp (XDRAW of Franklin and Ray, Higher isn't
/// necessarily better, SDH 1994): the highest slope from the lamp on the way to a post is
/// interpolated between the two posts of the ring before that the way passes; the share of the
/// lamp over it makes the penumbra. As many steps as posts; shadow edges widen and wander with the
/// distance, as is XDRAW's way.
class LampPreview
{
public:
  /// `terrain`: with the point array Elevation, which is copied; its spacing counts as metres.
  explicit LampPreview(vtkImageData* terrain);

  /// Irradiance RGB at every post by a lamp whose centre lies at height `z`.
  vtkSmartPointer<vtkFloatArray> Light(const ViewerLamp& lamp, double z) const;

  /// The share of the lamp that every post sees, 0 to 1, by the terrain between them alone.
  std::vector<float> Visibility(const ViewerLamp& lamp, double z) const;

private:
  std::ptrdiff_t Columns, Rows;
  double Origin[2], Spacing[2];
  std::vector<float> Heights;
  std::vector<float> East, North; ///< slopes
};

} // namespace skyline

#endif
