// SPDX-License-Identifier: BSD-3-Clause
// Limits of heights and distances between posts for which float arithmetic is safe.
#ifndef skyline_HeightLimits_h
#define skyline_HeightLimits_h

namespace skyline
{

/// Greatest absolute height in metres. A post with a greater one is missing. The square of this
/// limit is a finite float.
constexpr double GreatestHeight = 1.0e12;

/// Metres between posts.
constexpr double LeastSpacing = 1.0e-9;
constexpr double GreatestSpacing = 1.0e9;

} // namespace skyline

#endif
