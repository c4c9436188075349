// SPDX-License-Identifier: BSD-3-Clause
// A checksum of the heights of a field.
#ifndef skyline_HeightChecksum_h
#define skyline_HeightChecksum_h

#include <cstdint>

namespace skyline
{

class HeightField;

/// Returns a checksum of all heights, missing posts included. Two fields of different heights have
/// the same checksum with a probability of about 2^-64. It is never 0. It is computed in threads; the result does not depend on their number.
std::uint64_t HeightChecksum(const HeightField& field);

} // namespace skyline

#endif
