// SPDX-License-Identifier: BSD-3-Clause
// Bands of rows that are computed with one spacing.
#ifndef skyline_RowBands_h
#define skyline_RowBands_h

#include "SkylineCoreModule.h" // for the export macro

#include <cstddef>
#include <vector>

namespace skyline
{

class GroundMetric;

/// Relative error of a distance inside a band. 0.05 % changes no horizon by more than 0.0143
/// degrees, and one of 15 degrees by 0.0072 degrees at the edge of the band.
constexpr double RowBandTolerance = 0.0005;

/// Rows [RowBegin, RowEnd) that are computed with one spacing, in metres.
struct RowBand
{
  std::ptrdiff_t RowBegin = 0, RowEnd = 0;
  double SpacingX = 1.0, SpacingY = 1.0;
};

/// Splits the rows, from south to north, into the fewest bands in which the spacing of no row
/// differs from that of the band by more than `tolerance` (relative, default RowBandTolerance, at
/// least 0). Returns one band with the spacing at the centre unless each row has its own spacing
/// (GroundMetric::ByRows). Throws std::invalid_argument for a negative tolerance.
SKYLINECORE_EXPORT std::vector<RowBand> RowBands(
  const GroundMetric& metric, double tolerance = RowBandTolerance);

} // namespace skyline

#endif
