// SPDX-License-Identifier: BSD-3-Clause
// How much light the sky has left when the sun is below the horizon.
#ifndef skyline_Twilight_h
#define skyline_Twilight_h

#include "Color/Daylight.h"

namespace skyline
{

/// Illuminance of open level ground under a clear sky without a moon, lux, for a sun at an elevation
/// of -18 to 0 degrees without refraction; beyond, that at the nearer end. The four polynomials of
/// Janiczek and DeYoung, Computer Programs for Sun and Moon Illuminance, United States Naval
/// Observatory Circular 171 (1987): 759 lx at 0, 3.4 at -6, 0.008 at -12, 0.00065 at -18 degrees.
double TwilightIlluminance(double elevation);

/// That over the illuminance at 0 degrees: 1 by day, 8.5e-7 by night. NaN gives 1.
double TwilightShare(double elevation);

/// Sun and sky as ClearDaylight has them by day; below the horizon the sky's light goes out, blue where
/// there is air. elevation: of the sun, degrees.
Daylight DaylightAndNight(double elevation, bool air);

} // namespace skyline

#endif
