// SPDX-License-Identifier: BSD-3-Clause
// How much light the sky has when the sun is below the horizon.
#ifndef skyline_Twilight_h
#define skyline_Twilight_h

#include "Color/Daylight.h"

namespace skyline
{

/// The illuminance of open level ground under a clear sky without a moon, in lux, for an elevation
/// of the sun of -18 to 0 degrees without refraction. Outside this range it is that of the nearer
/// limit. Source: the four polynomials of Janiczek and DeYoung, Computer Programs for Sun and Moon
/// Illuminance, United States Naval Observatory Circular 171 (1987): 759 lx at 0, 3.4 at -6, 0.008
/// at -12, 0.00065 at -18 degrees.
double TwilightIlluminance(double elevation);

/// That illuminance divided by the one at 0 degrees: 1 by day, 8.5e-7 by night. NaN gives 1.
double TwilightShare(double elevation);

/// Sun and sky as in ClearDaylight by day. Below the horizon the light of the sky fades, and it
/// becomes blue if there is air. `elevation` is that of the sun in degrees.
Daylight DaylightAndNight(double elevation, bool air);

} // namespace skyline

#endif
