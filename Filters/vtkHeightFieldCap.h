// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldCap
 * @brief   raises a height field to the objects on it, so that they cast shadows
 *
 * Input 0 is a height field (see vtkHeightFieldAlgorithm). Input 1 is a vtkPolyData in the
 * coordinates of that image, with z in metres like the heights. The output is the image, with the
 * height of each post under a polygon raised to the highest polygon there (Lee & Kim, figure 8).
 * The output heights keep their name; they are double if the input heights are double, and float
 * otherwise.
 *
 * Everything between the ground and the polygon counts as solid. This suits objects that stand on
 * the ground, such as houses; an aircraft would cast the shadow of a pillar. An object that lies
 * between posts, such as a wall thinner than their spacing, raises no height. Missing posts stay
 * missing.
 *
 * Each error is reported by one ErrorEvent with a text of one line. The output is then empty.
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
  /// Set the objects to put on the height field: input 1.
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
