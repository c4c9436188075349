// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVHeightFieldIrradiance
 * @brief   vtkHeightFieldIrradiance for ParaView, with its lights as properties
 *
 * ParaView's panels, state files and animations support only numbers, texts and lists of them.
 * Therefore this filter has properties for one sun, one sky and any number of lamps, from which it
 * makes the light objects.
 */
#ifndef vtkPVHeightFieldIrradiance_h
#define vtkPVHeightFieldIrradiance_h

#include "SkylineParaViewModule.h" // For export macro
#include "vtkHeightFieldIrradiance.h"
#include "vtkNew.h"                 // For the lights
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"        // For Lamps

#include <string> // For EnvironmentFile
#include <vector> // For Lamps

VTK_ABI_NAMESPACE_BEGIN
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
    SUN_BY_DIRECTION = 1, ///< direction by SunAzimuth and SunElevation
    SUN_BY_TIME = 2       ///< direction by SunTime and HoursLater; needs a georeference
  };
  enum SkyType
  {
    NO_SKY = 0,
    UNIFORM_SKY = 1, ///< radiance SkyRadiance in all directions
    FILE_SKY = 2,    ///< the light map EnvironmentFile, multiplied by SkyRadiance
    CIE_SKY = 3,     ///< sky CieType, with SkyRadiance at the zenith
    PEREZ_SKY = 4    ///< from DirectIrradiance and DiffuseIrradiance, times SkyRadiance
  };

  ///@{
  /// The kind of sun; default SUN_BY_DIRECTION. The skies CIE_SKY and PEREZ_SKY are bright around
  /// the position of the sun even with NO_SUN.
  vtkSetClampMacro(Sun, int, NO_SUN, SUN_BY_TIME);
  vtkGetMacro(Sun, int);
  ///@}

  ///@{
  /// See vtkSkylineSunLight. Defaults: azimuth 315, elevation 45, radius 0.26645 degrees;
  /// irradiance 1, 1, 1. With SUN_BY_TIME, the radius follows from the distance of the sun.
  void SetSunAzimuth(double degrees);
  void SetSunElevation(double degrees);
  void SetSunAngularRadius(double degrees);
  void SetSunIrradiance(double red, double green, double blue);
  void SetLimbDarkening(bool on);
  ///@}

  ///@{
  /// A time in ISO 8601, UTC unless a zone is given, such as 2026-06-21T14:00Z (default: empty),
  /// and hours after that time (default: 0).
  void SetSunTime(const char* time);
  void SetHoursLater(double hours);
  ///@}

  ///@{
  /// The kind of sky; default UNIFORM_SKY.
  vtkSetClampMacro(Sky, int, NO_SKY, PEREZ_SKY);
  vtkGetMacro(Sky, int);
  ///@}

  ///@{
  /// See vtkSkylineEnvironmentLight. Defaults: radiance 1, 1, 1; CIE type 12; direct irradiance 800
  /// and diffuse irradiance 100 W/m^2.
  void SetSkyRadiance(double red, double green, double blue);
  void SetCieType(int type);
  void SetDirectIrradiance(double irradiance);
  void SetDiffuseIrradiance(double irradiance);
  ///@}

  ///@{
  /// The light map file for FILE_SKY, in a format of vtkSkylineLightMapReader (.hdr, .exr). It is
  /// read once. Default: empty.
  vtkSetMacro(EnvironmentFile, std::string);
  vtkGetMacro(EnvironmentFile, std::string);
  ///@}

  ///@{
  /// Degrees by which the light map is turned clockwise, seen from above. Default: 0.
  vtkSetMacro(Rotation, double);
  vtkGetMacro(Rotation, double);
  ///@}

  ///@{
  /// Adds a lamp: position (x and y in coordinates of the image, z in the frame of the heights) and
  /// radius, all in metres, and radiance (RGB). RemoveAllLamps removes all lamps. Default: none.
  void AddLamp(double x, double y, double z, double radius, double red, double green, double blue);
  void RemoveAllLamps();
  ///@}

protected:
  vtkPVHeightFieldIrradiance();
  ~vtkPVHeightFieldIrradiance() override;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

  int Sun = SUN_BY_DIRECTION;
  int Sky = UNIFORM_SKY;
  std::string EnvironmentFile;
  double Rotation = 0.0;

private:
  void PlaceSun(const skyline::HorizonDriver& driver);
  void ReadEnvironment();

  vtkNew<vtkSkylineSunLight> SunLight;
  vtkNew<vtkSkylineEnvironmentLight> SkyLight;
  std::vector<vtkSmartPointer<vtkSkylineLampLight>> Lamps;
  std::string ReadFile; // the file whose light map the sky holds

  vtkPVHeightFieldIrradiance(const vtkPVHeightFieldIrradiance&) = delete;
  void operator=(const vtkPVHeightFieldIrradiance&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
