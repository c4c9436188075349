// SPDX-License-Identifier: BSD-3-Clause
// Heights and distances between posts that float arithmetic takes.
#ifndef skyline_HeightLimits_h
#define skyline_HeightLimits_h

namespace skyline
{

/// Greatest height of ground, metres, of either sign: a number beyond it is no height, and its post is
/// missing. The square of this one still is a finite float.
constexpr double GreatestHeight = 1.0e12;

/// Metres between posts.
constexpr double LeastSpacing = 1.0e-9;
constexpr double GreatestSpacing = 1.0e9;

} // namespace skyline

#endif
