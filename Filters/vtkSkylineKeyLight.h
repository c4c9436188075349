// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineKeyLight
 * @brief   a soft lamp in the sky: an even disc of any size, infinitely far away
 *
 * The key light of Snyder & Nowrouzezahrai 2008, section 6. Its light comes from above the horizontal
 * plane only.
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
  /// Degrees clockwise from grid north (any number of turns; default 315), and elevation, -90 to 90
  /// degrees (default 45).
  vtkSetMacro(Azimuth, double);
  vtkGetMacro(Azimuth, double);
  vtkSetMacro(Elevation, double);
  vtkGetMacro(Elevation, double);
  ///@}

  ///@{
  /// Of the disc, degrees, above 0 to below 90; default 10.
  vtkSetMacro(AngularRadius, double);
  vtkGetMacro(AngularRadius, double);
  ///@}

  ///@{
  /// RGB, 0 or more, of every part of the disc; default 1, 1, 1. On an open plane that faces it the
  /// disc gives pi sin^2(AngularRadius) of that.
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
