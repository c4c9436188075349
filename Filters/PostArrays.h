// SPDX-License-Identifier: BSD-3-Clause
// The arrays that filters put out: values of every post, row by row.
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

/// Adds a float array with so many components a post; its values are not set. std::runtime_error if there
/// is no memory for it.
vtkFloatArray* AddPostArray(vtkImageData* output, const char* name, int components = 1);

/// Sets all components of an array to NaN at the field's missing posts.
void BlankMissing(const HeightField& field, vtkFloatArray* array);

/// Counts the posts that are not missing and have a component that is NaN or infinite.
std::ptrdiff_t CountNotFinite(const HeightField& field, vtkFloatArray* array);

} // namespace skyline

#endif
