// SPDX-License-Identifier: BSD-3-Clause
// A number that names the heights of a field.
#ifndef skyline_HeightChecksum_h
#define skyline_HeightChecksum_h

#include <cstdint>

namespace skyline
{

class HeightField;

/// Names the heights, missing posts included: other heights give another number. Never 0. Runs in threads;
/// the result does not depend on their number.
std::uint64_t HeightChecksum(const HeightField& field);

} // namespace skyline

#endif
