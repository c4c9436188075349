// SPDX-License-Identifier: BSD-3-Clause
// A moment some hours after another one, so that an animation can vary a number.
#ifndef skyline_HoursAfter_h
#define skyline_HoursAfter_h

#include "SkylineCoreModule.h" // for the export macro
#include "Sun/UtcTime.h"

namespace skyline
{

/// The moment `hours` after `time`. hours: may be negative; above -1e7 and below 1e7; 0 gives
/// `time` itself. Leap seconds in between are not counted. Throws std::invalid_argument, which
/// names the number, for other values.
SKYLINECORE_EXPORT UtcTime HoursAfter(const UtcTime& time, double hours);

} // namespace skyline

#endif
