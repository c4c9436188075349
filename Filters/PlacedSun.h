// SPDX-License-Identifier: BSD-3-Clause
// The sun of a vtkSkylineSunLight over a height field. All filters with a sun use these functions.
#ifndef skyline_PlacedSun_h
#define skyline_PlacedSun_h

#include "Geo/Georeference.h"
#include "Sun/Eclipse.h"
#include "Sun/SunField.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkSkylineSunLight;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Returns the directions to the sun over the posts: with UseTime those at that time at the place
/// of each post, with the air at the height `meanHeight` in metres; otherwise one direction on the
/// image. Throws std::invalid_argument or std::out_of_range, with the value, as ParseUtcTime and
/// SunField do.
SunField SunFieldOf(vtkSkylineSunLight* sun, const Georeference& place, double meanHeight);

/// Returns the Moon in front of that sun; empty without UseTime. Throws as SunFieldOf does.
EclipseField EclipseFieldOf(vtkSkylineSunLight* sun, const Georeference& place, double meanHeight);

/// Returns the angular radius of the disc in degrees: with UseTime and TrueRadius that of `field`,
/// otherwise that of the light. Throws std::out_of_range, with the value, unless it is 0 to below
/// 90.
double RadiusOf(vtkSkylineSunLight* sun, const SunField& field);

/// Returns the limb darkening of the disc, as SunAccumulator takes it; 0 if LimbDarkening is off.
double LimbDarkeningOf(vtkSkylineSunLight* sun);

/// Returns the value of a SunField or an EclipseField over the middle of the posts.
template <typename Field>
auto InTheMiddle(const Field& field, const Georeference& place)
{
  return field.At(
    0.5 * static_cast<double>(place.Columns - 1), 0.5 * static_cast<double>(place.Rows - 1));
}

} // namespace skyline

#endif
