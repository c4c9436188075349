// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVHeightFieldIrradiance
 * @brief   vtkHeightFieldIrradiance with its lights as plain properties
 *
 * ParaView's panels, state files and animations know numbers, texts and lists of them. So this holds
 * one sun, one sky and any number of lamps, and makes the light objects of them.
 */
#ifndef vtkPVHeightFieldIrradiance_h
#define vtkPVHeightFieldIrradiance_h

#include "SkylineParaViewModule.h" // For export macro
#include "vtkHeightFieldIrradiance.h"
#include "vtkNew.h"          // For the lights
#include "vtkSmartPointer.h" // For Lamps

#include <string> // For EnvironmentFile
#include <vector> // For Lamps

class vtkSkylineEnvironmentLight;
class vtkSkylineLampLight;
class vtkSkylineSunLight;

class SKYLINEPARAVIEW_EXPORT vtkPVHeightFieldIrradiance : public vtkHeightFieldIrradiance
{
public:
  static vtkPVHeightFieldIrradiance* New();
  vtkTypeMacro(vtkPVHeightFieldIrradiance, vtkHeightFieldIrradiance);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SunType
  {
    NO_SUN = 0,
    SUN_BY_DIRECTION = 1, ///< SunAzimuth, SunElevation
    SUN_BY_TIME = 2       ///< SunTime and HoursLater; needs a georeference
  };
  enum SkyType
  {
    NO_SKY = 0,
    UNIFORM_SKY = 1, ///< SkyRadiance all over
    FILE_SKY = 2,    ///< the light map EnvironmentFile times SkyRadiance
    CIE_SKY = 3,     ///< CieType, zenith SkyRadiance
    PEREZ_SKY = 4    ///< of DirectIrradiance and DiffuseIrradiance, times SkyRadiance
  };

  ///@{
  /// Which sun shines; default SUN_BY_DIRECTION. The skies CIE_SKY and PEREZ_SKY are bright around the
  /// place of the sun even where none shines.
  vtkSetClampMacro(Sun, int, NO_SUN, SUN_BY_TIME);
  vtkGetMacro(Sun, int);
  ///@}

  ///@{
  /// See vtkSkylineSunLight; defaults 315, 45, 0.26645 degrees, 1, 1, 1. By time the radius is true.
  void SetSunAzimuth(double degrees);
  void SetSunElevation(double degrees);
  void SetSunAngularRadius(double degrees);
  void SetSunIrradiance(double red, double green, double blue);
  void SetLimbDarkening(bool on);
  ///@}

  ///@{
  /// UTC as ISO 8601, for instance 2026-06-21T14:00Z, and hours after it; default empty, 0.
  void SetSunTime(const char* time);
  void SetHoursLater(double hours);
  ///@}

  ///@{
  /// Which sky shines; default UNIFORM_SKY.
  vtkSetClampMacro(Sky, int, NO_SKY, PEREZ_SKY);
  vtkGetMacro(Sky, int);
  ///@}

  ///@{
  /// See vtkSkylineEnvironmentLight; defaults 1, 1, 1; 12; 800, 100 W/m^2.
  void SetSkyRadiance(double red, double green, double blue);
  void SetCieType(int type);
  void SetDirectIrradiance(double irradiance);
  void SetDiffuseIrradiance(double irradiance);
  ///@}

  ///@{
  /// A light map that vtkLightMapReader reads (.hdr, .exr), for FILE_SKY; read once.
  vtkSetMacro(EnvironmentFile, std::string);
  vtkGetMacro(EnvironmentFile, std::string);
  ///@}

  ///@{
  /// Degrees by which the light map is turned clockwise, seen from above; default 0.
  vtkSetMacro(Rotation, double);
  vtkGetMacro(Rotation, double);
  ///@}

  ///@{
  /// Lamps: position (x, y in the image's coordinates, height), radius, all in metres; radiance.
  void AddLamp(double x, double y, double z, double radius, double red, double green, double blue);
  void RemoveAllLamps();
  ///@}

protected:
  vtkPVHeightFieldIrradiance();
  ~vtkPVHeightFieldIrradiance() override;

  bool Compute(skyline::HorizonScene& scene, vtkImageData* output) override;

  int Sun = SUN_BY_DIRECTION;
  int Sky = UNIFORM_SKY;
  std::string EnvironmentFile;
  double Rotation = 0.0;

private:
  void PlaceSun(const skyline::HorizonScene& scene);
  void ReadEnvironment();

  vtkNew<vtkSkylineSunLight> SunLight;
  vtkNew<vtkSkylineEnvironmentLight> SkyLight;
  std::vector<vtkSmartPointer<vtkSkylineLampLight>> Lamps;
  std::string ReadFile; // whose light map the sky holds

  vtkPVHeightFieldIrradiance(const vtkPVHeightFieldIrradiance&) = delete;
  void operator=(const vtkPVHeightFieldIrradiance&) = delete;
};

#endif
