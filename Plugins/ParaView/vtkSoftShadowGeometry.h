// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowGeometry
 * @brief   what vtkSoftShadowRepresentation draws: the surface of a height field, and its light
 *
 * Input: a whole vtkImageData of one slice; on a process without data anything else, which gives an
 * empty surface. Output: the triangles of vtkHeightFieldSurface with the point arrays of up to four
 * components, and in the field data what skyline::PackLight puts there. In a parallel run the first
 * process makes the surface, and the others none, so that no seam and nothing twice is drawn.
 */
#ifndef vtkSoftShadowGeometry_h
#define vtkSoftShadowGeometry_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "SkylineParaViewModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For names

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEPARAVIEW_EXPORT vtkSoftShadowGeometry : public vtkPolyDataAlgorithm
{
public:
  static vtkSoftShadowGeometry* New();
  vtkTypeMacro(vtkSoftShadowGeometry, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  static constexpr int AUTOMATIC = -1;

  ///@{
  /// Name of the point array with the heights; default empty: Elevation, or else the active scalars.
  vtkSetMacro(ElevationArray, std::string);
  vtkGetMacro(ElevationArray, std::string);
  ///@}

  ///@{
  /// See vtkHeightFieldSurface; default 1.
  vtkSetMacro(Exaggeration, double);
  vtkGetMacro(Exaggeration, double);
  vtkSetClampMacro(Stride, int, 1, VTK_INT_MAX);
  vtkGetMacro(Stride, int);
  ///@}

  ///@{
  /// Which light to pack, see vtkSoftShadowShader::ModeType; default AUTOMATIC: the first of
  /// Irradiance, TransferSH and VisibilitySH that is there.
  vtkSetMacro(Mode, int);
  vtkGetMacro(Mode, int);
  ///@}

protected:
  vtkSoftShadowGeometry() = default;
  ~vtkSoftShadowGeometry() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

  std::string ElevationArray;
  double Exaggeration = 1.0;
  int Stride = 1;
  int Mode = AUTOMATIC;

private:
  vtkSoftShadowGeometry(const vtkSoftShadowGeometry&) = delete;
  void operator=(const vtkSoftShadowGeometry&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
