// SPDX-License-Identifier: BSD-3-Clause
// The figures of a finding by name, for every table.
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
  const char* Name; ///< in CSV and JSON
  const char* Head; ///< on the page; null: not there
  double (*Value)(const Result&);
};

/// Errors in the unit of the quantity, times in nanoseconds for the part that its chart names.
const std::vector<Figure>& Figures();

} // namespace benchmark
} // namespace skyline

#endif
