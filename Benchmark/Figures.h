// SPDX-License-Identifier: BSD-3-Clause
// The figures of a finding by name, for all tables.
#ifndef skyline_Figures_h
#define skyline_Figures_h

#include "Result.h"

#include <vector>

namespace skyline
{
namespace benchmark
{

struct Figure
{
  const char* Name; ///< name in CSV and JSON
  const char* Head; ///< heading on the page; null if the page does not show it
  double (*Value)(const Result&);
};

/// Errors are in the unit of the quantity. Times are in nanoseconds per part, as named in the
/// chart.
const std::vector<Figure>& Figures();

} // namespace benchmark
} // namespace skyline

#endif
