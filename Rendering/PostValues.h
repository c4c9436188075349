// SPDX-License-Identifier: BSD-3-Clause
// Numbers per post, as a PostTexture takes them.
#ifndef skyline_PostValues_h
#define skyline_PostValues_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Components [first, first + count) of all posts, missing posts filled.
std::vector<float> PostValues(vtkDataArray* array, int first, int count, int columns, int rows);

/// dz/dx and dz/dy of all posts, as the filters have them, missing posts filled.
std::vector<float> PostGradients(vtkImageData* image, vtkDataArray* heights);

} // namespace skyline

#endif
