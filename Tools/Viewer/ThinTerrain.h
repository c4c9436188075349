// SPDX-License-Identifier: BSD-3-Clause
// Every n-th post of a terrain.
#ifndef skyline_ThinTerrain_h
#define skyline_ThinTerrain_h

#include "vtkSmartPointer.h"

class vtkImageData;

namespace skyline
{

/// The point array Elevation at every n-th post of columns and rows, n the least for which about
/// `posts` remain. Without the georeference: rows count as evenly spaced.
vtkSmartPointer<vtkImageData> ThinTerrain(vtkImageData* terrain, double posts);

} // namespace skyline

#endif
