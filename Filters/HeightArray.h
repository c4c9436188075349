// SPDX-License-Identifier: BSD-3-Clause
// Checks and reads the heights that a filter gets, and turns exceptions into error texts.
#ifndef skyline_HeightArray_h
#define skyline_HeightArray_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkType.h"

#include <functional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Throws std::invalid_argument, with the size of the image, unless the image is one slice of at
/// least 2 x 2 posts.
void CheckSurface(vtkImageData* image);

/// Throws std::invalid_argument unless the array has one component and one tuple per post. Null:
/// there is no array.
void CheckHeights(vtkImageData* image, vtkDataArray* heights);

/// Calls `work` and returns the text of the exception that it throws, in one line; empty if it
/// throws none. If there is not enough memory, the text has the size of the image.
std::string ReasonOfFailure(vtkImageData* image, const std::function<void()>& work);

/// Returns the base height of the array in metres (HeightField/BaseHeight.h), or 0 if all posts are
/// missing.
double BaseHeightOf(vtkDataArray* heights);

/// Copies the tuples `first` to `first + count` of the array into `values`, tuple by tuple. Arrays
/// of VTK's usual types are read without a virtual call per value.
void ReadTuples(vtkDataArray* array, vtkIdType first, vtkIdType count, double* values);

} // namespace skyline

#endif
