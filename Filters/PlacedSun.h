// SPDX-License-Identifier: BSD-3-Clause
// The sun of a vtkSkylineSunLight over a height field: every filter that takes a sun reads it here.
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

/// Directions to the sun over the posts: with UseTime, of that time at the place of each post, with the
/// air of `meanHeight` metres; else one direction on the image. Throws std::invalid_argument or
/// std::out_of_range, naming the value, as ParseUtcTime and SunField do.
SunField SunFieldOf(vtkSkylineSunLight* sun, const Georeference& place, double meanHeight);

/// The Moon before that sun; empty without UseTime. Throws as SunFieldOf.
EclipseField EclipseFieldOf(vtkSkylineSunLight* sun, const Georeference& place, double meanHeight);

/// Angular radius of the disc in degrees: with UseTime and TrueRadius that of `field`, else the light's.
/// Throws std::out_of_range, naming the number, unless it is 0 to below 90.
double RadiusOf(vtkSkylineSunLight* sun, const SunField& field);

/// Of the light's disc, as SunAccumulator takes it: 0 where LimbDarkening is off.
double LimbDarkeningOf(vtkSkylineSunLight* sun);

/// What a SunField or an EclipseField has over the middle of the posts.
template <typename Field>
auto InTheMiddle(const Field& field, const Georeference& place)
{
  return field.At(
    0.5 * static_cast<double>(place.Columns - 1), 0.5 * static_cast<double>(place.Rows - 1));
}

} // namespace skyline

#endif
