// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineKeyLight
 * @brief   a distant, evenly bright disc of any angular radius
 *
 * This is the key light of Snyder & Nowrouzezahrai 2008, section 6. Only the part above the
 * horizontal plane gives light. Values out of range are an error of the filter that uses the light.
 */
#ifndef vtkSkylineKeyLight_h
#define vtkSkylineKeyLight_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSkylineLight.h"

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkSkylineKeyLight : public vtkSkylineLight
{
public:
  static vtkSkylineKeyLight* New();
  vtkTypeMacro(vtkSkylineKeyLight, vtkSkylineLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Set/Get the azimuth in degrees clockwise from grid north (any finite number; default 315), and
  /// the elevation in degrees, -90 to 90 (default 45).
  vtkSetMacro(Azimuth, double);
  vtkGetMacro(Azimuth, double);
  vtkSetMacro(Elevation, double);
  vtkGetMacro(Elevation, double);
  ///@}

  ///@{
  /// Set/Get the angular radius of the disc in degrees, above 0 and below 90. The default is 10.
  vtkSetMacro(AngularRadius, double);
  vtkGetMacro(AngularRadius, double);
  ///@}

  ///@{
  /// Set/Get the radiance of the disc: RGB, 0 or more. The default is 1, 1, 1. The irradiance on an
  /// open plane that faces the disc is pi sin^2(AngularRadius) times this.
  vtkSetVector3Macro(Radiance, double);
  vtkGetVector3Macro(Radiance, double);
  ///@}

protected:
  vtkSkylineKeyLight() = default;
  ~vtkSkylineKeyLight() override = default;

  double Azimuth = 315.0;
  double Elevation = 45.0;
  double AngularRadius = 10.0;
  double Radiance[3] = { 1.0, 1.0, 1.0 };

private:
  vtkSkylineKeyLight(const vtkSkylineKeyLight&) = delete;
  void operator=(const vtkSkylineKeyLight&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
