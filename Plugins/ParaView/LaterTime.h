// SPDX-License-Identifier: BSD-3-Clause
// Moments some hours after a moment: what an animation in ParaView can vary.
#ifndef skyline_LaterTime_h
#define skyline_LaterTime_h

#include <string>

namespace skyline
{

/// ISO 8601 text of the moment `hours` (any finite number, also negative) after `time` (see
/// ParseUtcTime). Leap seconds between the two are not counted. With 0 hours, the text as it is.
/// Throws std::invalid_argument for a text that is no time and for hours that are no number.
std::string LaterTime(const std::string& time, double hours);

} // namespace skyline

#endif
