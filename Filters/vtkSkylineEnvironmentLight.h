// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineEnvironmentLight
 * @brief   light from all of the sky: a light map, or a sky by formula
 *
 * It counts above the horizontal plane only. The sun of a sky is not part of it: it is a
 * vtkSkylineSunLight of its own, and the sky is only brighter around it.
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

  /// What an environment's light is taken from.
  enum SourceType
  {
    UNIFORM = 0, ///< the same radiance everywhere: Radiance
    IMAGE = 1,   ///< Image times Radiance
    CIE = 2,     ///< a sky of CIE S 011 whose zenith has Radiance
    PEREZ = 3 ///< Perez's all-weather sky of DirectIrradiance and DiffuseIrradiance, times Radiance
  };

  ///@{
  /// What the environment is; default UNIFORM.
  vtkSetClampMacro(Source, int, UNIFORM, PEREZ);
  vtkGetMacro(Source, int);
  void SetSourceToUniform() { this->SetSource(UNIFORM); }
  void SetSourceToImage() { this->SetSource(IMAGE); }
  void SetSourceToCie() { this->SetSource(CIE); }
  void SetSourceToPerez() { this->SetSource(PEREZ); }
  ///@}

  /// Sets Source, and what belongs to it, from the text of a sky: "uniform", "cie:N" (N from 1 to 16) or
  /// "perez:DIRECT,DIFFUSE" (W/m2, as DirectIrradiance and DiffuseIrradiance). Returns false, and changes
  /// nothing, where the text is the name of a light map's file: read that by vtkSkylineLightMapReader, for
  /// SetImage. Any other text is an error.
  bool SetSky(const char* text);
#ifndef __VTK_WRAP__
  /// The same for a sky that has been read; SkyKind::None switches the light off.
  bool SetSky(const skyline::SkyDescription& sky);
#endif

  /// Whether it looks the same in all azimuths, so that neither Rotation nor the sun change it: a uniform
  /// sky, and some of CIE's.
  bool IsSameAllAround();

  ///@{
  /// RGB, 0 or more: radiance, or the factor on one, by Source; default 1, 1, 1.
  vtkSetVector3Macro(Radiance, double);
  vtkGetVector3Macro(Radiance, double);
  ///@}

  ///@{
  /// A light map as vtkSkylineLightMapReader gives it: "Radiance", three floats a pixel,
  /// latitude-longitude, the centre column north. Negative and NaN pixels count as 0. Setting one
  /// sets Source to IMAGE.
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage();
  ///@}

  ///@{
  /// Degrees by which image and sky are turned clockwise about the vertical, seen from above: the
  /// map's north comes to this grid azimuth. Default 0.
  vtkSetMacro(Rotation, double);
  vtkGetMacro(Rotation, double);
  ///@}

  ///@{
  /// Number of the CIE sky: 1 to 15 of CIE S 011/E:2003, 16 the traditional overcast sky; default 12,
  /// the clear sky of clean air.
  vtkSetMacro(CieType, int);
  vtkGetMacro(CieType, int);
  ///@}

  ///@{
  /// W/m^2, for PEREZ: the sun's on a plane that faces it, 0 or more, default 800, and the sky's on
  /// level open ground, above 0, default 100. With the sun on or under the horizon the sky is dark.
  vtkSetMacro(DirectIrradiance, double);
  vtkGetMacro(DirectIrradiance, double);
  vtkSetMacro(DiffuseIrradiance, double);
  vtkGetMacro(DiffuseIrradiance, double);
  ///@}

  ///@{
  /// Where the sun of a CIE or Perez sky stands before Rotation: degrees clockwise from grid north
  /// (default 315), and apparent elevation (default 45).
  vtkSetMacro(SunAzimuth, double);
  vtkGetMacro(SunAzimuth, double);
  vtkSetMacro(SunElevation, double);
  vtkGetMacro(SunElevation, double);
  ///@}

  /// The time of the last change of this light or of its image.
  vtkMTimeType GetMTime() override;

  /// What the kernels see, valid until the light changes. Throws std::invalid_argument with a
  /// one-line reason: no image, no such sky.
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

  std::vector<float> Pixels; // of a sky, or of an image that had to be mended
  bool PixelsAreImage = false;
  vtkMTimeType PixelTime = 0;
};
VTK_ABI_NAMESPACE_END

#endif
