// SPDX-License-Identifier: BSD-3-Clause
// Numbers per post, in the form that PostTexture needs.
#ifndef skyline_PostValues_h
#define skyline_PostValues_h

#include "SkylineRenderingModule.h" // for the export macro
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Components [first, first + count) of all posts. Missing posts are filled.
std::vector<float> PostValues(vtkDataArray* array, int first, int count, int columns, int rows);

/// The gradients dz/dx and dz/dy on the ground of all posts, as the filters compute them. Missing
/// posts are filled. Throws std::invalid_argument or std::runtime_error, as HorizonInput does.
SKYLINERENDERING_EXPORT std::vector<float> PostGradients(
  vtkImageData* image, vtkDataArray* heights);

} // namespace skyline

#endif
