// SPDX-License-Identifier: BSD-3-Clause
// Where and with what a benchmark ran.
#ifndef skyline_Machine_h
#define skyline_Machine_h

#include <string>
#include <utility>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// Names and values: date, processor, cores and load, vector target, compiler, versions of the peers.
std::vector<std::pair<std::string, std::string>> MachineFacts();

/// The same as lines "name: value".
std::string DescribeMachine();

/// Load averages of the machine now: what else may have slowed the figures.
std::string Load();

} // namespace benchmark
} // namespace skyline

#endif
