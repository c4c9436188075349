// SPDX-License-Identifier: BSD-3-Clause
// The methods that the benchmark compares, by name.
#ifndef skyline_Methods_h
#define skyline_Methods_h

#include "Result.h"
#include "Truth.h"

#include <functional>
#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// How much of a benchmark to run.
struct Plan
{
  int Repeats = 3;       ///< of the timed part
  std::size_t Thin = 8;  ///< slow methods run in every Thin-th azimuth
  int GrassAzimuths = 2; ///< of r.horizon, the slowest
};

struct Method
{
  std::string Name; ///< on the command line and in the CSV
  std::string Label;
  std::function<Result(const Scene&, const Truth&, const Plan&)> Measure;
};

/// All of them, in the order of the table.
const std::vector<Method>& Methods();

/// What the labels mean, a line each.
std::string DescribeMethods();

} // namespace benchmark
} // namespace skyline

#endif
