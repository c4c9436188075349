// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineSoftShadowRepresentation
 * @brief   the representation Soft Shadow Surface: a height field in its own light
 *
 * Draws the surface of an image of heights in the light that its point arrays hold, at the
 * resolution of the posts (vtkSkylineSoftShadowShader). The light is the array Irradiance, or
 * TransferSH or VisibilitySH with a key light and a sky, which can move without new horizons. The
 * colours of ParaView (a solid colour or an array) are the albedo. The lights of ParaView have no
 * effect. In a parallel run, the first process draws the whole height field.
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

  /// The array that gives the light, see vtkSkylineSoftShadowShader::ModeType. Default:
  /// vtkSkylineSoftShadowGeometry::AUTOMATIC.
  void SetLightMode(int mode);

  ///@{
  /// The key light of TRANSFER and VISIBILITY, a disc. KeyAzimuth: degrees clockwise from grid
  /// north (default 315). KeyElevation: degrees (default 45). KeyRadius: angular radius in degrees
  /// (default 0.27; the harmonics blur discs below 20 degrees more). KeyIrradiance: irradiance on a
  /// plane that faces the light, RGB (default 3, 3, 3).
  vtkSetMacro(KeyAzimuth, double);
  vtkSetMacro(KeyElevation, double);
  vtkSetClampMacro(KeyRadius, double, 0.0, 89.0);
  vtkSetVector3Macro(KeyIrradiance, double);
  ///@}

  /// Radiance of the uniform sky of TRANSFER and VISIBILITY, RGB. Default: 0.2, 0.25, 0.3.
  vtkSetVector3Macro(SkyRadiance, double);

  ///@{
  /// Exposure in stops. With AutoExposure (the default), it is a correction of the exposure that
  /// shows the light best.
  vtkSetMacro(Exposure, double);
  vtkSetMacro(AutoExposure, bool);
  ///@}

  /// Whether the tone curve is applied, see vtkSkylineSoftShadowShader. Default: true.
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
  vtkDataObject* LightOf = nullptr; // whose light the shader holds; compared, not dereferenced
  vtkMTimeType LightTime = 0;
  double ArrayExposure = 0.0;

  vtkSkylineSoftShadowRepresentation(const vtkSkylineSoftShadowRepresentation&) = delete;
  void operator=(const vtkSkylineSoftShadowRepresentation&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
