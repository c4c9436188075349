// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldInspection
 * @brief   warns of a height field in memory whose heights may not mean what they seem to mean
 *
 * What vtkHeightFieldReader finds in rasters, for images that a program made: heights that often stand
 * for missing posts, and degrees taken for metres (Documentation/input.md). Each doubt is a WarningEvent
 * of this object. Nothing is changed.
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

  /// Looks at the active point scalars, one component, and at the spacing and georeference of an image.
  /// subject: what the warnings call it, "the array". Does nothing for an image without such scalars.
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
