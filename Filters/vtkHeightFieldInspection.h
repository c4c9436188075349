// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldInspection
 * @brief   warns if the heights of an image may not mean what they seem to mean
 *
 * vtkHeightFieldReader checks rasters; this class makes the same checks for an image that a program
 * made in memory. It looks for heights that often stand for missing posts, and for degrees that are
 * taken for metres (see Documentation/input.md). Each finding is one WarningEvent of this object.
 * The image is not changed.
 */
#ifndef vtkHeightFieldInspection_h
#define vtkHeightFieldInspection_h

#include "SkylineFiltersModule.h" // for the export macro
#include "vtkObject.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

class SKYLINEFILTERS_EXPORT vtkHeightFieldInspection : public vtkObject
{
public:
  static vtkHeightFieldInspection* New();
  vtkTypeMacro(vtkHeightFieldInspection, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Check an image: its active point scalars, if they have one component, its spacing and its
  /// georeference. `subject` is the name of the image in the warnings, such as "the array"; null
  /// stands for "the height field". An image without such scalars is not checked.
  void Inspect(vtkImageData* heightField, const char* subject);

protected:
  vtkHeightFieldInspection() = default;
  ~vtkHeightFieldInspection() override = default;

private:
  vtkHeightFieldInspection(const vtkHeightFieldInspection&) = delete;
  void operator=(const vtkHeightFieldInspection&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
