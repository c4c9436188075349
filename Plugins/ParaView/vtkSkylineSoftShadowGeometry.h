// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineSoftShadowGeometry
 * @brief   the surface of a height field, with its light, for vtkSkylineSoftShadowRepresentation
 *
 * Input: a whole vtkImageData of one slice. On a process without data, any other data set, for
 * which the surface is empty. Output: the triangles of vtkHeightFieldSurface with the point arrays
 * of up to four components, and in the field data what skyline::StoreLight stores there. In a
 * parallel run, the first process makes the whole surface and the others make none, so that there
 * are no seams and nothing is drawn twice.
 */
#ifndef vtkSkylineSoftShadowGeometry_h
#define vtkSkylineSoftShadowGeometry_h

#include "SkylineParaViewModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <string> // For names

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEPARAVIEW_EXPORT vtkSkylineSoftShadowGeometry : public vtkPolyDataAlgorithm
{
public:
  static vtkSkylineSoftShadowGeometry* New();
  vtkTypeMacro(vtkSkylineSoftShadowGeometry, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  static constexpr int AUTOMATIC = -1;

  ///@{
  /// Name of the point array with the heights. Default: empty, which means Elevation, or the active
  /// scalars if there is no such array.
  vtkSetMacro(ElevationArray, std::string);
  vtkGetMacro(ElevationArray, std::string);
  ///@}

  ///@{
  /// See vtkHeightFieldSurface. Default: 1.
  vtkSetMacro(Exaggeration, double);
  vtkGetMacro(Exaggeration, double);
  vtkSetClampMacro(Stride, int, 1, VTK_INT_MAX);
  vtkGetMacro(Stride, int);
  ///@}

  ///@{
  /// The light to pass on, see vtkSkylineSoftShadowShader::ModeType. Default: AUTOMATIC, which
  /// takes the first of Irradiance, TransferSH and VisibilitySH that exists.
  vtkSetMacro(Mode, int);
  vtkGetMacro(Mode, int);
  ///@}

protected:
  vtkSkylineSoftShadowGeometry() = default;
  ~vtkSkylineSoftShadowGeometry() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

  std::string ElevationArray;
  double Exaggeration = 1.0;
  int Stride = 1;
  int Mode = AUTOMATIC;

private:
  vtkSkylineSoftShadowGeometry(const vtkSkylineSoftShadowGeometry&) = delete;
  void operator=(const vtkSkylineSoftShadowGeometry&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
