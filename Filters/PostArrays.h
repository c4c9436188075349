// SPDX-License-Identifier: BSD-3-Clause
// The output arrays of filters: values of each post, row by row.
#ifndef skyline_PostArrays_h
#define skyline_PostArrays_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN
class vtkFloatArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

class HeightField;

/// Adds a float array with `components` components per post; its values are not initialized. Throws
/// std::runtime_error if there is not enough memory.
vtkFloatArray* AddPostArray(vtkImageData* output, const char* name, int components = 1);

/// Sets all components of an array to NaN at the missing posts of the field.
void BlankMissing(const HeightField& field, vtkFloatArray* array);

/// Counts the posts that are not missing and have a component that is NaN or infinite.
std::ptrdiff_t CountNotFinite(const HeightField& field, vtkFloatArray* array);

} // namespace skyline

#endif
