// SPDX-License-Identifier: BSD-3-Clause
// One measurement to make, and what it found.
#ifndef skyline_Job_h
#define skyline_Job_h

#include "Measure.h"
#include "Result.h"

#include <functional>
#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// What is measured: a chart of its own for every scene.
struct Quantity
{
  std::string Name;     ///< "horizon"
  std::string Title;    ///< "Horizons"
  std::string Error;    ///< axis: what the error is, with its unit
  std::string Time;     ///< axis: what the time is, with its unit
  bool ByWrong = false; ///< the error of the charts is WrongPercent, else the rmse
};

/// All of them, in the order of the report.
const std::vector<Quantity>& Quantities();
const Quantity& FindQuantity(const std::string& name);

/// Names that --methods takes: what a method is, whatever its settings.
const std::vector<std::string>& Kinds();

/// Who measures what where.
struct Task
{
  std::string Quantity; ///< a name of Quantities()
  std::string Scene;
  std::string Kind;     ///< a name of Kinds()
  std::string Label;    ///< short, at the point of a chart
  std::string Settings; ///< in words
  int Turn = 0;         ///< what matters most comes first
};

struct Job
{
  Task What;
  std::function<void()> Prepare; ///< finds the truth once; not timed
  std::function<Result()> Measure;
};

struct Finding
{
  Task What;
  Result Found;
  double Seconds = 0.0; ///< wall time, with a truth that was found for it
};

/// The coordinates of a finding in its chart: nanoseconds (CPU, median; wall where the processor is
/// another's) and error. NaN if not measured.
double TimeOf(const Finding& finding);
double ErrorOf(const Finding& finding);

} // namespace benchmark
} // namespace skyline

#endif
