// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldSunShadow
 * @brief   how much of the sun every post sees
 *
 * Adds `SunVisibility`: the lit fraction of the sun's disc above the horizon curve across its swath,
 * 0 (full shadow) to 1. The sun is one direction for all posts, or, with UseTime, the sun of that
 * time at the place of each post (needs a georeference). Only the swath of the sun is searched.
 *
 * In an eclipse at that time the visibility is multiplied by the share of the sun's light that the Moon
 * leaves at the post (skyline::EclipseField). The product is exact where the terrain leaves all of the
 * disc or none, and in totality; where it cuts the disc of an eclipsed sun it can be off by 0.25, for
 * the horizon may cut the bright part or the dark one.
 */
#ifndef vtkHeightFieldSunShadow_h
#define vtkHeightFieldSunShadow_h

#include "vtkHeightFieldAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkHeightFieldSunShadow : public vtkHeightFieldAlgorithm
{
public:
  static vtkHeightFieldSunShadow* New();
  vtkTypeMacro(vtkHeightFieldSunShadow, vtkHeightFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The sun's azimuth, degrees clockwise from grid north (any number of turns; default 315), and
  /// its apparent elevation, -90 to 90 degrees (default 45). Unused with UseTime.
  vtkSetMacro(SunAzimuth, double);
  vtkGetMacro(SunAzimuth, double);
  vtkSetMacro(SunElevation, double);
  vtkGetMacro(SunElevation, double);
  ///@}

  ///@{
  /// Angular radius of the disc, degrees, 0 (a point) to below 90; default 0.26645, the mean sun's.
  /// With UseTime and TrueRadius it is unused.
  vtkSetMacro(SunAngularRadius, double);
  vtkGetMacro(SunAngularRadius, double);
  ///@}

  ///@{
  /// With UseTime, take the angular radius that follows from the sun's distance; default on.
  vtkSetMacro(TrueRadius, bool);
  vtkGetMacro(TrueRadius, bool);
  vtkBooleanMacro(TrueRadius, bool);
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
  /// Let the disc darken towards its limb (Eddington, u = 0.6); default off.
  vtkSetMacro(LimbDarkening, bool);
  vtkGetMacro(LimbDarkening, bool);
  vtkBooleanMacro(LimbDarkening, bool);
  ///@}

  /// Azimuths searched by the last execution.
  vtkGetMacro(SearchedAzimuths, int);

protected:
  vtkHeightFieldSunShadow() = default;
  ~vtkHeightFieldSunShadow() override = default;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

  double SunAzimuth = 315.0;
  double SunElevation = 45.0;
  double SunAngularRadius = 0.26645;
  bool TrueRadius = true;
  bool UseTime = false;
  std::string Time;
  bool LimbDarkening = false;
  int SearchedAzimuths = 0;

private:
  vtkHeightFieldSunShadow(const vtkHeightFieldSunShadow&) = delete;
  void operator=(const vtkHeightFieldSunShadow&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
