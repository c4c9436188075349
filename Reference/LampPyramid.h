// SPDX-License-Identifier: BSD-3-Clause
// Horizons in front of a lamp from a pyramid of smoothed heights: the local lights of THESIS,
// section 4.3.1, with the pyramid of Snyder & Nowrouzezahrai (2008).
#ifndef skyline_LampPyramid_h
#define skyline_LampPyramid_h

#include "HeightField/Grid.h"
#include "HeightField/HeightPyramid.h"
#include "Horizon/HorizonMethod.h"
#include "Lamps/Lamp.h"

#include <cstddef>

namespace skyline
{

/// Does the same as FindLampHorizons in LampHarmonics.h, with the samples of the thesis: each level
/// gives one angle at its distance. Used are the levels nearer than the lamp's centre and the next
/// one (equation 4.24). The horizon is the greatest value, at the knots and halfway between them up
/// to the lamp, of a cubic B-spline of these angles over the logarithm of the distance (4.25).
/// Angles may be negative. The first level whose sample lies outside the data ends the sequence. A
/// lamp that is nearer than the finest sample gets the angle of this sample. The horizons are
/// smooth, and wrong by degrees where the terrain is not smooth: they serve for the figures of the
/// thesis and for moving terrain.
///
/// Expand of the pyramid is not needed, because heights are interpolated where they are read.
void FindLampHorizons(const HeightPyramid& pyramid, const PyramidSettings& settings,
  const Grid& grid, double drop, const Lamp& lamp, double azimuth, std::ptrdiff_t rowBegin,
  std::ptrdiff_t rowEnd, float* slopes);

} // namespace skyline

#endif
