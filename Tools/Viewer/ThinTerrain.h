// SPDX-License-Identifier: BSD-3-Clause
// Selects every n-th post of a terrain.
#ifndef skyline_ThinTerrain_h
#define skyline_ThinTerrain_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// The point array Elevation at every n-th column and row; n is the least number for which about
/// `posts` posts remain. The result has no georeference: its rows count as evenly spaced.
vtkSmartPointer<vtkImageData> ThinTerrain(vtkImageData* terrain, double posts);

} // namespace skyline

#endif
