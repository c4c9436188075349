// SPDX-License-Identifier: BSD-3-Clause
// The sun over a terrain: at a time and place, or in a direction.
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

/// The sun at one place. Angles are in degrees.
struct SunLight
{
  bool FromTime = false;           ///< given by --time
  bool TrueNorth = false;          ///< the place is known, and thus true north
  double GridAzimuth = 315.0;      ///< clockwise from the +y axis of the image, 0 to below 360
  double SkyAzimuth = 315.0;       ///< on the ground from +y of the image, as for light maps
  double TrueAzimuth = 315.0;      ///< clockwise from true north, 0 to below 360, if TrueNorth
  double Elevation = 45.0;         ///< without refraction; equals the next one if --sun is given
  double ApparentElevation = 45.0; ///< with refraction
  double Radius = 0.0;             ///< of the disc
};

/// Finds the sun over the centre of the terrain, at `height` metres. Without --time and --sun:
/// azimuth 315 from grid north, elevation 45. Throws Failure for --time without a place on the
/// Earth, and the exceptions of ParseUtcTime and ComputeSun.
SunLight FindSun(const SunDescription& asked, const Georeference& place, double height);

/// Sets this sun on a light: by time, so that it differs from post to post, or by direction.
void ApplySun(const SunDescription& asked, const SunLight& sun, vtkSkylineSunLight* light);

} // namespace skyline

#endif
