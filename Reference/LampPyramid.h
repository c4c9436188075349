// SPDX-License-Identifier: BSD-3-Clause
// Horizons in front of a lamp from a pyramid of smoothed heights: the local lights of THESIS,
// section 4.3.1, on the pyramid of Snyder & Nowrouzezahrai 2008.
#ifndef skyline_LampPyramid_h
#define skyline_LampPyramid_h

#include "HeightField/Grid.h"
#include "HeightField/HeightPyramid.h"
#include "Horizon/PyramidSettings.h"
#include "Lamps/Lamp.h"

#include <cstddef>

namespace skyline
{

/// As FindLampHorizons (LampHarmonics.h), by the thesis's samples: the angle of each level at its
/// distance, those nearer than the lamp's centre and the next one beyond (equation 4.24), a cubic
/// b-spline over log distance, and its greatest value at and halfway between knots up to the lamp
/// (4.25). Angles keep their sign. Levels whose sample lies outside the data end the sequence; a lamp
/// nearer than the finest sample has that sample's angle. Smooth, and off by degrees where terrain is
/// not: for the thesis's figures and for moving terrain.
///
/// Needs no Expand of the pyramid: heights are splined where they are read.
void FindLampHorizons(const HeightPyramid& pyramid, const PyramidSettings& settings,
  const Grid& grid, double sink, const Lamp& lamp, double azimuth, std::ptrdiff_t rowBegin,
  std::ptrdiff_t rowEnd, float* slopes);

} // namespace skyline

#endif
