// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineEnvironmentLight
 * @brief   light from the whole sky: a light map or a sky formula
 *
 * Only the part above the horizontal plane counts. A sky formula is brighter around the sun, but
 * the sun itself is not included: add a vtkSkylineSunLight for it.
 */
#ifndef vtkSkylineEnvironmentLight_h
#define vtkSkylineEnvironmentLight_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSkylineLight.h"

#include "vtkSmartPointer.h"

#include <vector>

namespace skyline
{
struct SkyDescription;
struct TurnedLightMap;
} // namespace skyline

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

class SKYLINEFILTERS_EXPORT vtkSkylineEnvironmentLight : public vtkSkylineLight
{
public:
  static vtkSkylineEnvironmentLight* New();
  vtkTypeMacro(vtkSkylineEnvironmentLight, vtkSkylineLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The sources of the light.
  enum SourceType
  {
    UNIFORM = 0, ///< Radiance, the same in all directions
    IMAGE = 1,   ///< Image, multiplied by Radiance
    CIE = 2,     ///< a sky of CIE S 011 that has Radiance at the zenith
    PEREZ = 3    ///< the all-weather sky of Perez (Direct-, DiffuseIrradiance), times Radiance
  };

  ///@{
  /// Set/Get the source of the light. The default is UNIFORM.
  vtkSetClampMacro(Source, int, UNIFORM, PEREZ);
  vtkGetMacro(Source, int);
  void SetSourceToUniform() { this->SetSource(UNIFORM); }
  void SetSourceToImage() { this->SetSource(IMAGE); }
  void SetSourceToCie() { this->SetSource(CIE); }
  void SetSourceToPerez() { this->SetSource(PEREZ); }
  ///@}

  /// Set Source and its parameters from a text: "uniform", "cie:N" (N from 1 to 16) or
  /// "perez:DIRECT,DIFFUSE" (W/m2, see DirectIrradiance and DiffuseIrradiance). If the text is the
  /// name of a light map file, the method returns false and changes nothing: read the file with
  /// vtkSkylineLightMapReader and call SetImage. Any other text is an error.
  bool SetSky(const char* text);
#ifndef __VTK_WRAP__
  /// The same for a parsed description. SkyKind::None switches the light off.
  bool SetSky(const skyline::SkyDescription& sky);
#endif

  /// Return whether the light is the same in all azimuths, so that neither Rotation nor the sun
  /// changes it. This is so for a uniform sky and for some CIE skies.
  bool IsSameAllAround();

  ///@{
  /// Set/Get the radiance, or the factor on it (see SourceType): RGB, 0 or more. The default is 1,
  /// 1, 1. Negative or non-finite values are an error of the filter that uses the light.
  vtkSetVector3Macro(Radiance, double);
  vtkGetVector3Macro(Radiance, double);
  ///@}

  ///@{
  /// Set/Get a light map as vtkSkylineLightMapReader makes it: the point array "Radiance" with
  /// three floats per pixel, in latitude-longitude projection, with north in the centre column.
  /// Negative and NaN pixels count as 0. SetImage also sets Source to IMAGE.
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage();
  ///@}

  ///@{
  /// Set/Get by how many degrees image or sky are turned clockwise about the vertical, seen from
  /// above: the north of the map then points to this grid azimuth. The default is 0.
  vtkSetMacro(Rotation, double);
  vtkGetMacro(Rotation, double);
  ///@}

  ///@{
  /// Set/Get the number of the CIE sky: 1 to 15 of CIE S 011/E:2003, 16 for the traditional
  /// overcast sky. The default is 12, the clear sky of clean air.
  vtkSetMacro(CieType, int);
  vtkGetMacro(CieType, int);
  ///@}

  ///@{
  /// Set/Get the irradiances of PEREZ in W/m^2: DirectIrradiance by the sun on a plane that faces
  /// it, 0 or more, default 800; DiffuseIrradiance by the sky on level open ground, above 0,
  /// default 100. If the sun is not above the horizon, the sky is dark.
  vtkSetMacro(DirectIrradiance, double);
  vtkGetMacro(DirectIrradiance, double);
  vtkSetMacro(DiffuseIrradiance, double);
  vtkGetMacro(DiffuseIrradiance, double);
  ///@}

  ///@{
  /// Set/Get the position of the sun in a CIE or Perez sky, before Rotation: azimuth in degrees
  /// clockwise from grid north (default 315), and apparent elevation in degrees (default 45).
  vtkSetMacro(SunAzimuth, double);
  vtkGetMacro(SunAzimuth, double);
  vtkSetMacro(SunElevation, double);
  vtkGetMacro(SunElevation, double);
  ///@}

  /// Get the time of the last change of this light or of its image.
  vtkMTimeType GetMTime() override;

  /// Get the light in the form that the kernels use. It is valid until the light changes. Throws
  /// std::invalid_argument with a reason of one line if there is no image or no such sky.
  skyline::TurnedLightMap GetLightMap();

protected:
  vtkSkylineEnvironmentLight();
  ~vtkSkylineEnvironmentLight() override;

  int Source = UNIFORM;
  double Radiance[3] = { 1.0, 1.0, 1.0 };
  vtkSmartPointer<vtkImageData> Image;
  double Rotation = 0.0;
  int CieType = 12;
  double DirectIrradiance = 800.0;
  double DiffuseIrradiance = 100.0;
  double SunAzimuth = 315.0;
  double SunElevation = 45.0;

private:
  vtkSkylineEnvironmentLight(const vtkSkylineEnvironmentLight&) = delete;
  void operator=(const vtkSkylineEnvironmentLight&) = delete;

  void FillPixels();

  std::vector<float> Pixels; // of a sky, or a corrected copy of an image
  bool PixelsAreImage = false;
  vtkMTimeType PixelTime = 0;
};
VTK_ABI_NAMESPACE_END

#endif
