// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowGeometry
 * the surface of a height field and its light, as drawn by vtkSoftShadowRepresentation
 *
 * Input: a whole vtkImageData of one slice. On a process without data, any other data set, for
 * which the surface is empty. Output: the triangles of vtkHeightFieldSurface with the point arrays
 * of up to four components, and in the field data what skyline::PackLight stores there. In a
 * parallel run, the first process makes the whole surface and the others make none, so that there
 * are no seams and nothing is drawn twice.
 */
#ifndef vtkSoftShadowGeometry_h
#define vtkSoftShadowGeometry_h

#include "SkylineParaViewModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For names

class SKYLINEPARAVIEW_EXPORT vtkSoftShadowGeometry : public vtkPolyDataAlgorithm
{
public:
  static vtkSoftShadowGeometry* New();
  vtkTypeMacro(vtkSoftShadowGeometry, vtkPolyDataAlgorithm);
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
  /// The light to pass on, see vtkSoftShadowShader::ModeType. Default: AUTOMATIC, which takes the
  /// first of Irradiance, TransferSH and VisibilitySH that exists.
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

#endif
