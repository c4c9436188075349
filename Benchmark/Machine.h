// SPDX-License-Identifier: BSD-3-Clause
// Where and with what a benchmark ran.
#ifndef skyline_Machine_h
#define skyline_Machine_h

#include <string>

namespace skyline
{
namespace benchmark
{

/// Lines "name: value": date, processor, cores and load, vector target, compiler, peers.
std::string DescribeMachine();

/// Load averages of the machine now: what else may have slowed the figures.
std::string Load();

} // namespace benchmark
} // namespace skyline

#endif
