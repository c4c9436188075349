// SPDX-License-Identifier: BSD-3-Clause
// A moment some hours after another: a number that an animation can vary.
#ifndef skyline_HoursAfter_h
#define skyline_HoursAfter_h

#include "SkylineCoreModule.h" // for the export macro
#include "Sun/UtcTime.h"

namespace skyline
{

/// The moment `hours` (also negative; -1e7 to 1e7, both excluded) after `time`. Leap seconds between the
/// two are not counted. With 0 hours the same moment. Throws std::invalid_argument, naming the number, for
/// other hours.
SKYLINECORE_EXPORT UtcTime HoursAfter(const UtcTime& time, double hours);

} // namespace skyline

#endif
