// SPDX-License-Identifier: BSD-3-Clause
// The sun over a terrain: by time and place, or by its direction.
#ifndef skyline_SunLight_h
#define skyline_SunLight_h

#include "Geo/Georeference.h"
#include "LightDescription.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkSkylineSunLight;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// The sun at one place. Angles in degrees.
struct SunLight
{
  bool FromTime = false;           ///< by --time
  bool TrueNorth = false;          ///< the place is known, and with it true north
  double GridAzimuth = 315.0;      ///< clockwise from the image's +y, 0 up to 360
  double SkyAzimuth = 315.0;       ///< on the ground from the image's +y, as light maps count
  double TrueAzimuth = 315.0;      ///< clockwise from true north, 0 up to 360, if TrueNorth
  double Elevation = 45.0;         ///< without air; the same as below when given by --sun
  double ApparentElevation = 45.0; ///< lifted by the air
  double Radius = 0.0;             ///< of the disc
};

/// The sun over the centre of the terrain, at `height` metres. Without --time and --sun: azimuth
/// 315 from grid north, elevation 45. Throws Failure for --time without a place on the Earth, and what
/// ParseUtcTime and ComputeSun throw.
SunLight FindSun(const SunDescription& asked, const Georeference& place, double height);

/// Gives that sun to a light: by time, so that it differs from post to post, or by direction.
void ApplySun(const SunDescription& asked, const SunLight& sun, vtkSkylineSunLight* light);

} // namespace skyline

#endif
