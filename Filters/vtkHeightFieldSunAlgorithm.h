// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldSunAlgorithm
 * @brief   what the filters on horizons that take one sun have in common
 *
 * The sun is a vtkSkylineSunLight: a direction for all posts, or a time. Each filter has one of its own;
 * SetSun lets several filters share one, so that it is moved once for all of them. Where the sun stands
 * and how wide it is count; its irradiance and its Switch do not.
 *
 * The methods named after the sun's properties set and get those of GetSun().
 */
#ifndef vtkHeightFieldSunAlgorithm_h
#define vtkHeightFieldSunAlgorithm_h

#include "vtkHeightFieldAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSkylineSunLight.h"     // For the methods that set its properties
#include "vtkSmartPointer.h"        // For Sun

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkHeightFieldSunAlgorithm : public vtkHeightFieldAlgorithm
{
public:
  vtkTypeMacro(vtkHeightFieldSunAlgorithm, vtkHeightFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The sun; null gives the filter a new one with the default values.
  void SetSun(vtkSkylineSunLight* sun);
  vtkSkylineSunLight* GetSun() { return this->Sun; }
  ///@}

  ///@{
  /// The sun's azimuth, degrees clockwise from grid north (any number of turns; default 315), and
  /// its apparent elevation, -90 to 90 degrees (default 45). Unused with UseTime.
  void SetSunAzimuth(double degrees) { this->Sun->SetAzimuth(degrees); }
  double GetSunAzimuth() { return this->Sun->GetAzimuth(); }
  void SetSunElevation(double degrees) { this->Sun->SetElevation(degrees); }
  double GetSunElevation() { return this->Sun->GetElevation(); }
  ///@}

  ///@{
  /// Angular radius of the disc, degrees, 0 (a point) to below 90; default 0.26645, the mean sun's.
  /// With UseTime and TrueRadius it is unused.
  void SetSunAngularRadius(double degrees) { this->Sun->SetAngularRadius(degrees); }
  double GetSunAngularRadius() { return this->Sun->GetAngularRadius(); }
  ///@}

  ///@{
  /// With UseTime, take the angular radius that follows from the sun's distance; default on.
  void SetTrueRadius(bool on) { this->Sun->SetTrueRadius(on); }
  bool GetTrueRadius() { return this->Sun->GetTrueRadius(); }
  void TrueRadiusOn() { this->SetTrueRadius(true); }
  void TrueRadiusOff() { this->SetTrueRadius(false); }
  ///@}

  ///@{
  /// Take the sun of a time at the place of the posts, which needs a georeference; default off.
  void SetUseTime(bool on) { this->Sun->SetUseTime(on); }
  bool GetUseTime() { return this->Sun->GetUseTime(); }
  void UseTimeOn() { this->SetUseTime(true); }
  void UseTimeOff() { this->SetUseTime(false); }
  ///@}

  ///@{
  /// UTC as ISO 8601, for instance 2026-06-21T06:00Z, 1900 to 2100 (default empty), and hours after it
  /// (default 0).
  void SetTime(const char* time) { this->Sun->SetTime(time); }
  const char* GetTime() { return this->Sun->GetTime(); }
  void SetHoursLater(double hours) { this->Sun->SetHoursLater(hours); }
  double GetHoursLater() { return this->Sun->GetHoursLater(); }
  ///@}

  /// Also that of the sun.
  vtkMTimeType GetMTime() override;

protected:
  vtkHeightFieldSunAlgorithm();
  ~vtkHeightFieldSunAlgorithm() override;

  vtkSmartPointer<vtkSkylineSunLight> Sun;

private:
  vtkHeightFieldSunAlgorithm(const vtkHeightFieldSunAlgorithm&) = delete;
  void operator=(const vtkHeightFieldSunAlgorithm&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
