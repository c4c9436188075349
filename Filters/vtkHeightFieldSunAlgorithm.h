// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldSunAlgorithm
 * @brief   base class of the filters on horizons that have one sun
 *
 * The sun is a vtkSkylineSunLight: one direction for all posts, or a time. Each filter has a sun of
 * its own. With SetSun several filters can share one sun, so that one call moves it for all of
 * them. The filters use the direction and the angular radius of the sun; its irradiance and its
 * Switch are ignored.
 *
 * The methods named after properties of the sun set and get those of GetSun().
 */
#ifndef vtkHeightFieldSunAlgorithm_h
#define vtkHeightFieldSunAlgorithm_h

#include "vtkHeightFieldAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSkylineSunLight.h"     // for the methods that set its properties
#include "vtkSmartPointer.h"        // for Sun

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkHeightFieldSunAlgorithm : public vtkHeightFieldAlgorithm
{
public:
  vtkTypeMacro(vtkHeightFieldSunAlgorithm, vtkHeightFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Set/Get the sun. Null gives the filter a new sun with default values.
  void SetSun(vtkSkylineSunLight* sun);
  vtkSkylineSunLight* GetSun() { return this->Sun; }
  ///@}

  ///@{
  /// Set/Get the azimuth of the sun in degrees clockwise from grid north (any finite number;
  /// default 315), and its apparent elevation in degrees, -90 to 90 (default 45). Not used with
  /// UseTime.
  void SetSunAzimuth(double degrees) { this->Sun->SetAzimuth(degrees); }
  double GetSunAzimuth() { return this->Sun->GetAzimuth(); }
  void SetSunElevation(double degrees) { this->Sun->SetElevation(degrees); }
  double GetSunElevation() { return this->Sun->GetElevation(); }
  ///@}

  ///@{
  /// Set/Get the angular radius of the disc in degrees, 0 (a point) to below 90. The default is
  /// 0.26645, that of the mean sun. Not used if UseTime and TrueRadius are on.
  void SetSunAngularRadius(double degrees) { this->Sun->SetAngularRadius(degrees); }
  double GetSunAngularRadius() { return this->Sun->GetAngularRadius(); }
  ///@}

  ///@{
  /// With UseTime, use the angular radius that follows from the distance of the sun. The default is
  /// on.
  void SetTrueRadius(bool on) { this->Sun->SetTrueRadius(on); }
  bool GetTrueRadius() { return this->Sun->GetTrueRadius(); }
  void TrueRadiusOn() { this->SetTrueRadius(true); }
  void TrueRadiusOff() { this->SetTrueRadius(false); }
  ///@}

  ///@{
  /// Use the direction of the sun at a time, at the place of each post. This needs a georeference;
  /// without one the update is an error. The default is off.
  void SetUseTime(bool on) { this->Sun->SetUseTime(on); }
  bool GetUseTime() { return this->Sun->GetUseTime(); }
  void UseTimeOn() { this->SetUseTime(true); }
  void UseTimeOff() { this->SetUseTime(false); }
  ///@}

  ///@{
  /// Set/Get the time as ISO 8601, for instance 2026-06-21T06:00Z, in the years 1900 to 2100
  /// (default empty; UTC if it names no time zone), and the hours that are added to it (default 0).
  void SetTime(const char* time) { this->Sun->SetTime(time); }
  const char* GetTime() { return this->Sun->GetTime(); }
  void SetHoursLater(double hours) { this->Sun->SetHoursLater(hours); }
  double GetHoursLater() { return this->Sun->GetHoursLater(); }
  ///@}

  /// Get the time of the last change of this filter or of its sun.
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
