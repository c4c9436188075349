// SPDX-License-Identifier: BSD-3-Clause
// Where a benchmark ran, and with which software.
#ifndef skyline_Machine_h
#define skyline_Machine_h

#include <string>
#include <utility>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// Names and values: date, processor, cores and load, vector target, compiler, versions of the
/// other programs.
std::vector<std::pair<std::string, std::string>> MachineFacts();

/// The same facts as lines "name: value".
std::string DescribeMachine();

/// The load averages of the machine, which show whether other work may have slowed the measurement.
std::string Load();

} // namespace benchmark
} // namespace skyline

#endif
