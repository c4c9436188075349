// SPDX-License-Identifier: BSD-3-Clause
// The exposure of the window: automatic, which lets night be dark, or fixed.
#ifndef skyline_Exposure_h
#define skyline_Exposure_h

namespace skyline
{

/// Where the automatic exposure stops to follow in full: bright parts of the terrain (its 98th
/// percentile) are as dark as middle grey in daylight. Stops, log2(AutoLevel / ToneGrey).
constexpr double FullAdaptation = 1.92;

/// The share of the stops beyond, by which eye and camera do not adapt: night is 3 to 4 stops darker
/// than day, not twenty, and not none.
constexpr double UnadaptedShare = 0.2;

/// The automatic exposure of the window: that which would show the terrain as bright as by day
/// (stops), less a part of what lies beyond FullAdaptation. Rises with its argument, without a step.
double AdaptedStops(double stops);

} // namespace skyline

#endif
