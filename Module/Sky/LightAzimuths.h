// SPDX-License-Identifier: BSD-3-Clause
// Chooses the azimuths of horizons for light maps: more where a map is bright.
#ifndef skyline_LightAzimuths_h
#define skyline_LightAzimuths_h

#include "Sky/LightTable.h"
#include "SkylineCoreModule.h" // for the export macro

#include <vector>

namespace skyline
{

/// Azimuths (radians, rising from 0, below 2 pi): `count` evenly spaced ones (at least 1), and more
/// where the maps are bright. An interval is halved until it contains at most twice an even share
/// of the light of each map (over all azimuths, on a level plus a vertical receiver), or is at
/// most an eighth of a pixel wide. A map without bright spots adds no azimuths; the sun adds at
/// most its share of `count` and a few that lead up to it.
SKYLINECORE_EXPORT std::vector<double> LightAzimuths(
  int count, const std::vector<TurnedLightMap>& maps, bool refine = true);

} // namespace skyline

#endif
