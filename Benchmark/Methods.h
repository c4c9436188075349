// SPDX-License-Identifier: BSD-3-Clause
// The methods that the benchmark compares, by name.
#ifndef skyline_Methods_h
#define skyline_Methods_h

#include "ReferenceHorizons.h"
#include "Result.h"

#include <functional>
#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// How much of the benchmark to run.
struct Plan
{
  int Repeats = 3;       ///< repeats of the timed part
  std::size_t Thin = 8;  ///< slow methods run in one of Thin azimuths
  int GrassAzimuths = 2; ///< azimuths of r.horizon, the slowest method
};

struct Method
{
  std::string Name; ///< name on the command line and in the CSV
  std::string Label;
  std::function<Result(const Scene&, const ReferenceHorizons&, const Plan&)> Measure;
};

/// All methods, in the order of the table.
const std::vector<Method>& Methods();

/// The meaning of the labels, one line for each.
std::string DescribeMethods();

} // namespace benchmark
} // namespace skyline

#endif
