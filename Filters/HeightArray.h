// SPDX-License-Identifier: BSD-3-Clause
// The heights that a filter takes: what they must be, how rows are read, and what an error says.
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

/// Throws std::invalid_argument, with the image's size, unless the image is one slice of at least 2 x 2
/// posts.
void CheckSurface(vtkImageData* image);

/// Throws std::invalid_argument unless the array (null: there is none) has one number for each post.
void CheckHeights(vtkImageData* image, vtkDataArray* heights);

/// Calls `work` and returns the reason, in one line, of the exception that it throws; empty: it threw none.
/// Where the memory is not enough, the reason has the size of the image.
std::string ReasonOfFailure(vtkImageData* image, const std::function<void()>& work);

/// The base height of the array in metres (HeightField/BaseHeight.h); 0 where every post is missing.
double BaseHeightOf(vtkDataArray* heights);

/// Copies tuples `first` to `first + count` of the array into `values`, all components of a tuple next to
/// each other. Arrays of VTK's usual types are read without a virtual call for each value.
void ReadTuples(vtkDataArray* array, vtkIdType first, vtkIdType count, double* values);

} // namespace skyline

#endif
