// SPDX-License-Identifier: BSD-3-Clause
// The light of a height field as field data of its surface: ParaView moves the geometry that a
// representation makes from the processes that hold data to those that draw, and nothing else.
#ifndef skyline_LightCargo_h
#define skyline_LightCargo_h

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

/// Puts the image's frame and those of the named point arrays that it has into the field data of
/// `surface`. Values are shared, not copied.
void PackLight(vtkImageData* image, const std::vector<std::string>& arrays, vtkDataObject* surface);

/// The image that was packed into `surface` or, of a composite data set, into the first block that
/// carries one; null where there is none.
vtkSmartPointer<vtkImageData> UnpackLight(vtkDataObject* surface);

} // namespace skyline

#endif
