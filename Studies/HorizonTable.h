// SPDX-License-Identifier: BSD-3-Clause
// The table of a benchmark, as text and as CSV.
#ifndef skyline_HorizonTable_h
#define skyline_HorizonTable_h

#include "Methods.h"
#include "Result.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

struct Row
{
  std::string Scene;
  std::string Method; ///< Method::Name
  std::string Label;
  Result Found;
};

/// Prints all rows, then for each scene how many times faster exact is than the other programs.
void PrintTable(std::ostream& out, const std::vector<Row>& rows);
void PrintRatios(std::ostream& out, const std::vector<Row>& rows);

/// Prints the rows with all digits. Cells without a measurement are empty.
void PrintCsv(std::ostream& out, const std::vector<Row>& rows);

} // namespace benchmark
} // namespace skyline

#endif
