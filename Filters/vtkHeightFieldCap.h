// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldCap
 * @brief   puts houses on the height field, so that they cast shadows
 *
 * Inputs: 0, a height field (see vtkHeightFieldAlgorithm); 1, vtkPolyData in the frame of its image, z
 * in metres like the heights. Output: the image, its heights raised at every post under a polygon to
 * the highest polygon there (Lee & Kim, figure 8): double for heights in double, float otherwise, under
 * the same name. Everything between the ground and that polygon counts as solid, which suits what
 * stands on the ground; an aircraft would cast the shadow of a pillar. What lies between posts, such as
 * a wall thinner than their spacing, raises none. Missing posts stay missing.
 *
 * Errors are reported by ErrorEvent in one line; the output then is empty.
 */
#ifndef vtkHeightFieldCap_h
#define vtkHeightFieldCap_h

#include "SkylineFiltersModule.h"
#include "vtkImageAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithmOutput;
class vtkPolyData;

class SKYLINEFILTERS_EXPORT vtkHeightFieldCap : public vtkImageAlgorithm
{
public:
  static vtkHeightFieldCap* New();
  vtkTypeMacro(vtkHeightFieldCap, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// What to put on the height field: input 1.
  void SetObjectsConnection(vtkAlgorithmOutput* objects);
  void SetObjectsData(vtkPolyData* objects);
  ///@}

protected:
  vtkHeightFieldCap();
  ~vtkHeightFieldCap() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

private:
  vtkHeightFieldCap(const vtkHeightFieldCap&) = delete;
  void operator=(const vtkHeightFieldCap&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
