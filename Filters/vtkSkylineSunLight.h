// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineSunLight
 * @brief   the sun or the moon: a small bright disc
 *
 * The sun has one direction for all posts; with UseTime its direction is that of the given time at
 * the place of each post, which needs a georeference. Only the part above the horizontal plane
 * gives light. During an eclipse at that time the sun is dimmed at each post to what the Moon
 * leaves of it (for harmonics, to what is left over the middle of the height field). Skies are not
 * dimmed.
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
  /// Set/Get the azimuth in degrees clockwise from grid north (any finite number; default 315), and
  /// the apparent elevation in degrees, -90 to 90 (default 45). Not used with UseTime.
  vtkSetMacro(Azimuth, double);
  vtkGetMacro(Azimuth, double);
  vtkSetMacro(Elevation, double);
  vtkGetMacro(Elevation, double);
  ///@}

  ///@{
  /// Set/Get the angular radius of the disc in degrees, 0 (a point) to GetLargestRadius(). The
  /// default is 0.26645, that of the mean sun. Not used if UseTime and TrueRadius are on. Use
  /// vtkSkylineKeyLight for larger discs. (Filters that compute only shadows accept radii below 90
  /// degrees.)
  vtkSetMacro(AngularRadius, double);
  vtkGetMacro(AngularRadius, double);
  ///@}

  /// Get the largest angular radius for which irradiance is computed: 3 degrees. In larger discs
  /// the angle of incidence differs too much from part to part.
  static double GetLargestRadius();

  ///@{
  /// With UseTime, use the angular radius that follows from the distance of the sun. The default is
  /// on.
  vtkSetMacro(TrueRadius, bool);
  vtkGetMacro(TrueRadius, bool);
  vtkBooleanMacro(TrueRadius, bool);
  ///@}

  ///@{
  /// Set/Get the irradiance on an open plane that faces the sun: RGB, 0 or more. The default is 1,
  /// 1, 1.
  vtkSetVector3Macro(Irradiance, double);
  vtkGetVector3Macro(Irradiance, double);
  ///@}

  ///@{
  /// Use the direction of the sun at Time, at the place of each post. The default is off.
  vtkSetMacro(UseTime, bool);
  vtkGetMacro(UseTime, bool);
  vtkBooleanMacro(UseTime, bool);
  ///@}

  ///@{
  /// Set/Get the time as ISO 8601, for instance 2026-06-21T06:00Z, in the years 1900 to 2100; UTC
  /// if it names no time zone. The default is empty.
  vtkSetStdStringFromCharMacro(Time);
  vtkGetCharFromStdStringMacro(Time);
  ///@}

  ///@{
  /// FindTimeError returns what is wrong with a text as a Time, in one line, and an empty text if
  /// nothing is. NamesZone returns whether a valid Time names its time zone.
  static std::string FindTimeError(const std::string& text);
  static bool NamesZone(const std::string& text);
  ///@}

  ///@{
  /// Set/Get the hours that are added to Time; they may be negative. Use it for animations. The
  /// default is 0.
  vtkSetMacro(HoursLater, double);
  vtkGetMacro(HoursLater, double);
  ///@}

  ///@{
  /// Set/Get whether the disc darkens towards its limb (Eddington, u = 0.6). The default is off.
  vtkSetMacro(LimbDarkening, bool);
  vtkGetMacro(LimbDarkening, bool);
  vtkBooleanMacro(LimbDarkening, bool);
  ///@}

  /// Find where the sun stands over the middle of a height field, whose heights are its active
  /// scalars. `direction` gets the azimuth (clockwise from grid north), the apparent elevation and
  /// the angular radius, in degrees; with UseTime those at Time. Returns false, with one error, if
  /// the field has no place on the Earth or the time cannot be used.
  bool FindDirection(vtkImageData* heightField, double direction[3]);

  /// Find the eclipse of the sun at Time over the middle of a height field. `eclipse` gets the
  /// magnitude (the covered part of the diameter; if total or annular, the ratio of the two
  /// diameters) and the obscuration (the covered share of the area of the disc, 0 to 1). Both are 0
  /// without an eclipse, without UseTime, and off the Earth. Returns false, with one error, if the
  /// time cannot be used.
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
