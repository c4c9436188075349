// SPDX-License-Identifier: BSD-3-Clause
// Where a light map needs horizons close together.
#ifndef skyline_LightAzimuths_h
#define skyline_LightAzimuths_h

#include "Sky/LightTable.h"
#include "SkylineCoreModule.h" // for the export macro

#include <vector>

namespace skyline
{

/// Azimuths (radians, rising from 0, below 2 pi): `count` evenly spread ones (at least 1), and more
/// of them where the maps are bright: an interval is halved until it holds no more than twice an
/// even share of a map's light (over all azimuths, on a level receiver and an upright one), or is an
/// eighth of a pixel wide. A map without bright spots adds none; the sun, at most its share of
/// `count` and a few that lead up to it.
SKYLINECORE_EXPORT std::vector<double> LightAzimuths(
  int count, const std::vector<TurnedLightMap>& maps, bool refine = true);

} // namespace skyline

#endif
