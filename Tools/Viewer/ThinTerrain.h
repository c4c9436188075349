// SPDX-License-Identifier: BSD-3-Clause
// Every n-th post of a terrain.
#ifndef skyline_ThinTerrain_h
#define skyline_ThinTerrain_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// The point array Elevation at every n-th post of columns and rows, n the least for which about
/// `posts` remain. Without the georeference: rows count as evenly spaced.
vtkSmartPointer<vtkImageData> ThinTerrain(vtkImageData* terrain, double posts);

} // namespace skyline

#endif
