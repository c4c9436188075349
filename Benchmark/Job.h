// SPDX-License-Identifier: BSD-3-Clause
// One measurement and its result.
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

/// A measured quantity. Each scene has a chart of its own for it.
struct Quantity
{
  std::string Name;     ///< "horizon"
  std::string Title;    ///< "Horizons"
  std::string Error;    ///< axis title: the error with its unit
  std::string Time;     ///< axis title: the time with its unit
  bool ByWrong = false; ///< charts show WrongPercent as the error, not the rmse
};

/// All quantities, in the order of the report.
const std::vector<Quantity>& Quantities();
const Quantity& FindQuantity(const std::string& name);

/// The names that --methods accepts: the type of a method, whatever its settings.
const std::vector<std::string>& Kinds();

/// Which method measures which quantity on which scene.
struct Task
{
  std::string Quantity; ///< a name of Quantities()
  std::string Scene;
  std::string Kind;     ///< a name of Kinds()
  std::string Label;    ///< short text beside the point in a chart
  std::string Settings; ///< the settings as a text
  int Turn = 0;         ///< rank in the order of measurements; 0 comes first
};

struct Job
{
  Task What;
  std::function<void()> Prepare; ///< computes the reference once; not timed
  std::function<Result()> Measure;
};

struct Finding
{
  Task What;
  Result Found;
  double Seconds = 0.0; ///< wall time, including a reference that was computed for it
};

/// The coordinates of a finding in its chart: nanoseconds (median CPU time, or wall time if the
/// graphics processor computes) and error. NaN if not measured.
double TimeOf(const Finding& finding);
double ErrorOf(const Finding& finding);

} // namespace benchmark
} // namespace skyline

#endif
