// SPDX-License-Identifier: BSD-3-Clause
// Passes the light of a height field on as field data of its surface. ParaView moves only the
// geometry of a representation from the processes that hold data to those that draw.
#ifndef skyline_LightFieldData_h
#define skyline_LightFieldData_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Stores in the field data of `surface` the extent, origin and spacing of the image, and those of
/// the named point arrays that it has. The values are shared, not copied.
void StoreLight(
  vtkImageData* image, const std::vector<std::string>& arrays, vtkDataObject* surface);

/// The image that StoreLight stored in `surface` or, in a composite data set, in the first block
/// that has one; null if there is none.
vtkSmartPointer<vtkImageData> LoadLight(vtkDataObject* surface);

} // namespace skyline

#endif
