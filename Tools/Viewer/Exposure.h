// SPDX-License-Identifier: BSD-3-Clause
// The exposure of the window: automatic, with dark nights, or fixed.
#ifndef skyline_Exposure_h
#define skyline_Exposure_h

namespace skyline
{

/// The automatic exposure follows fully up to this many stops, log2(AutoLevel / ToneGrey): bright
/// parts of the terrain (its 98th percentile) are then as dark as middle grey in daylight.
constexpr double FullAdaptation = 1.92;

/// The share of the further stops to which eye and camera do not adapt: night is shown 3 to 4 stops
/// darker than day, not 20, and not 0.
constexpr double UnadaptedShare = 0.2;

/// The automatic exposure of the window in stops: `stops`, which would show the terrain as bright
/// as by day, minus a part of what exceeds FullAdaptation. The function is monotonic and
/// continuous.
double AdaptedStops(double stops);

} // namespace skyline

#endif
