// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineSoftShadowRepresentation
 * @brief   Soft Shadow Surface: a height field in its own light
 *
 * Draws the surface of an image of heights with the light that its point arrays hold, at the
 * resolution of the posts (vtkSkylineSoftShadowShader): Irradiance as it is; or TransferSH or VisibilitySH
 * times a key light and a sky, which move without new horizons. Colours of ParaView (solid or by an
 * array) are the albedo; its lights count for nothing. The whole height field is drawn by the first
 * process of a parallel run.
 */
#ifndef vtkSkylineSoftShadowRepresentation_h
#define vtkSkylineSoftShadowRepresentation_h

#include "SkylineParaViewModule.h" // For export macro
#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkNew.h"                 // For Shader
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkSkylineSoftShadowGeometry;
class vtkSkylineSoftShadowShader;

class SKYLINEPARAVIEW_EXPORT vtkSkylineSoftShadowRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkSkylineSoftShadowRepresentation* New();
  vtkTypeMacro(vtkSkylineSoftShadowRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// See vtkSkylineSoftShadowGeometry.
  void SetElevationArray(const char* name);
  void SetExaggeration(double factor);
  void SetStride(int posts);
  ///@}

  /// Where light comes from, see vtkSkylineSoftShadowShader::ModeType; default
  /// vtkSkylineSoftShadowGeometry::AUTOMATIC.
  void SetLightMode(int mode);

  ///@{
  /// The key light of TRANSFER and VISIBILITY: a disc at Azimuth, degrees clockwise from grid north
  /// (default 315), and Elevation (default 45), with Radius, degrees (default 0.27; below 20 the
  /// harmonics blur more); irradiance on a plane that faces it, RGB (default 3, 3, 3).
  vtkSetMacro(KeyAzimuth, double);
  vtkSetMacro(KeyElevation, double);
  vtkSetClampMacro(KeyRadius, double, 0.0, 89.0);
  vtkSetVector3Macro(KeyIrradiance, double);
  ///@}

  /// Radiance of the uniform sky of TRANSFER and VISIBILITY, RGB; default 0.2, 0.25, 0.3.
  vtkSetVector3Macro(SkyRadiance, double);

  ///@{
  /// Exposure in stops; with AutoExposure (default) a correction of what shows the light best.
  vtkSetMacro(Exposure, double);
  vtkSetMacro(AutoExposure, bool);
  ///@}

  /// The tone curve, see vtkSkylineSoftShadowShader; default on.
  void SetToneMapping(bool on);

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* in, vtkInformation* out) override;

protected:
  vtkSkylineSoftShadowRepresentation();
  ~vtkSkylineSoftShadowRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

private:
  void UpdateLight();

  vtkSkylineSoftShadowGeometry* Geometry; // the superclass owns it as its GeometryFilter
  vtkNew<vtkSkylineSoftShadowShader> Shader;
  int LightMode;
  double KeyAzimuth = 315.0;
  double KeyElevation = 45.0;
  double KeyRadius = 0.27;
  double KeyIrradiance[3] = { 3.0, 3.0, 3.0 };
  double SkyRadiance[3] = { 0.2, 0.25, 0.3 };
  double Exposure = 0.0;
  bool AutoExposure = true;
  vtkDataObject* LightOf = nullptr; // whose light the shader holds; compared, never followed
  vtkMTimeType LightTime = 0;
  double ArrayExposure = 0.0;

  vtkSkylineSoftShadowRepresentation(const vtkSkylineSoftShadowRepresentation&) = delete;
  void operator=(const vtkSkylineSoftShadowRepresentation&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
