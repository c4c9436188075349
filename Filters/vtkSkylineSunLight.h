// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineSunLight
 * @brief   the sun, or the moon: a small bright disc
 *
 * A direction for all posts, or, with UseTime, the sun of that time at the place of each post (needs
 * a georeference). Its light comes from above the horizontal plane only. In an eclipse at that time it is
 * dimmed, at each post, to what the Moon leaves of it (harmonics: over the middle); skies are not.
 */
#ifndef vtkSkylineSunLight_h
#define vtkSkylineSunLight_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSkylineLight.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

class SKYLINEFILTERS_EXPORT vtkSkylineSunLight : public vtkSkylineLight
{
public:
  static vtkSkylineSunLight* New();
  vtkTypeMacro(vtkSkylineSunLight, vtkSkylineLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Degrees clockwise from grid north (any number of turns; default 315), and apparent elevation, -90
  /// to 90 degrees (default 45). Unused with UseTime.
  vtkSetMacro(Azimuth, double);
  vtkGetMacro(Azimuth, double);
  vtkSetMacro(Elevation, double);
  vtkGetMacro(Elevation, double);
  ///@}

  ///@{
  /// Of the disc, degrees, 0 (a point) to GetLargestRadius(); default 0.26645, the mean sun's. With
  /// UseTime and TrueRadius it is unused. Larger lights are vtkSkylineKeyLight. (Filters of shadows alone
  /// take radii to below 90 degrees.)
  vtkSetMacro(AngularRadius, double);
  vtkGetMacro(AngularRadius, double);
  ///@}

  /// The largest angular radius of a sun that gives irradiance: 3 degrees. The parts of larger discs shine
  /// at different angles.
  static double GetLargestRadius();

  ///@{
  /// With UseTime, take the angular radius that follows from the sun's distance; default on.
  vtkSetMacro(TrueRadius, bool);
  vtkGetMacro(TrueRadius, bool);
  vtkBooleanMacro(TrueRadius, bool);
  ///@}

  ///@{
  /// RGB, 0 or more, on an open plane that faces the sun; default 1, 1, 1.
  vtkSetVector3Macro(Irradiance, double);
  vtkGetVector3Macro(Irradiance, double);
  ///@}

  ///@{
  /// Take the sun of Time at each post's place; default off.
  vtkSetMacro(UseTime, bool);
  vtkGetMacro(UseTime, bool);
  vtkBooleanMacro(UseTime, bool);
  ///@}

  ///@{
  /// UTC as ISO 8601, for instance 2026-06-21T06:00Z; 1900 to 2100. Default empty.
  vtkSetStdStringFromCharMacro(Time);
  vtkGetCharFromStdStringMacro(Time);
  ///@}

  ///@{
  /// What is wrong with a text as a Time, in one line (empty: nothing), and whether a text that is one says
  /// in which zone its clock is.
  static std::string FindTimeError(const std::string& text);
  static bool NamesZone(const std::string& text);
  ///@}

  ///@{
  /// Hours after Time, also negative, at which the sun is taken: a number to animate. Default 0.
  vtkSetMacro(HoursLater, double);
  vtkGetMacro(HoursLater, double);
  ///@}

  ///@{
  /// Let the disc darken towards its limb (Eddington, u = 0.6); default off.
  vtkSetMacro(LimbDarkening, bool);
  vtkGetMacro(LimbDarkening, bool);
  vtkBooleanMacro(LimbDarkening, bool);
  ///@}

  /// Where it stands over the middle of a height field: azimuth (clockwise from grid north) and
  /// apparent elevation, with UseTime those of Time there, and angular radius; degrees. The heights
  /// are the active scalars. False, with one error, where there is no such place or time.
  bool FindDirection(vtkImageData* heightField, double direction[3]);

  /// The eclipse of the sun of Time over the middle of a height field: magnitude (the covered part of
  /// the diameter; in totality, and with a ring, the ratio of both diameters) and obscuration (the
  /// covered share of the disc's area, 0 to 1). Both 0 without an eclipse, without UseTime, and off
  /// the Earth. False, with one error, where there is no such time.
  bool FindEclipse(vtkImageData* heightField, double eclipse[2]);

protected:
  vtkSkylineSunLight() = default;
  ~vtkSkylineSunLight() override = default;

  double Azimuth = 315.0;
  double Elevation = 45.0;
  double AngularRadius = 0.26645;
  bool TrueRadius = true;
  double Irradiance[3] = { 1.0, 1.0, 1.0 };
  bool UseTime = false;
  std::string Time;
  double HoursLater = 0.0;
  bool LimbDarkening = false;

private:
  vtkSkylineSunLight(const vtkSkylineSunLight&) = delete;
  void operator=(const vtkSkylineSunLight&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
