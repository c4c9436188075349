// SPDX-License-Identifier: BSD-3-Clause
// A time that is some hours after another one, so that an animation in ParaView can vary a number.
#ifndef skyline_LaterTime_h
#define skyline_LaterTime_h

#include <string>

namespace skyline
{

/// The time `hours` after `time` as ISO 8601 text (see ParseUtcTime). `hours` is any finite number
/// and may be negative; leap seconds are not counted. With 0 hours, the text is returned unchanged.
/// Throws std::invalid_argument if `time` is not a time, and if `hours` is not a number or too
/// large.
std::string LaterTime(const std::string& time, double hours);

} // namespace skyline

#endif
