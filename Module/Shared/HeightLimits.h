// SPDX-License-Identifier: BSD-3-Clause
// Heights and distances between posts that float arithmetic takes.
#ifndef skyline_HeightLimits_h
#define skyline_HeightLimits_h

namespace skyline
{

/// Greatest height of a post that surfaces know, metres: one beyond, of either sign, stands there. Its
/// square still is a finite float, and it hides nothing that ground hides less: seen from 1e7 m it stands
/// at 89.9994 degrees.
constexpr double GreatestHeight = 1.0e12;

/// Metres between posts.
constexpr double LeastSpacing = 1.0e-9;
constexpr double GreatestSpacing = 1.0e9;

} // namespace skyline

#endif
