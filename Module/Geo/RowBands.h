// SPDX-License-Identifier: BSD-3-Clause
// Bands of rows that can be computed with one spacing.
#ifndef skyline_RowBands_h
#define skyline_RowBands_h

#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <vector>

namespace skyline
{

class GroundMetric;

/// Error of a distance inside a band; 0.05 % turns no horizon by more than 0.0143 degrees, and one of 15
/// degrees by 0.0072 at the band's edge.
constexpr double RowBandTolerance = 0.0005;

/// Rows [RowBegin, RowEnd) to be computed with one spacing, metres.
struct RowBand
{
  std::ptrdiff_t RowBegin = 0, RowEnd = 0;
  double SpacingX = 1.0, SpacingY = 1.0;
};

/// Splits the rows, south to north, into the fewest bands in which no row's spacing differs from
/// the band's by more than `tolerance` (relative, default RowBandTolerance, at least 0). One band
/// with the centre's spacing unless every row has one of its own (GroundMetric::ByRows). Throws
/// std::invalid_argument for a negative tolerance.
SKYLINECORE_EXPORT std::vector<RowBand> RowBands(
  const GroundMetric& metric, double tolerance = RowBandTolerance);

} // namespace skyline

#endif
