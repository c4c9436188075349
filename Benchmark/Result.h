// SPDX-License-Identifier: BSD-3-Clause
// What the measurement of one method on one scene yields.
#ifndef skyline_Result_h
#define skyline_Result_h

#include <limits>
#include <type_traits>

namespace skyline
{
namespace benchmark
{

constexpr double NotMeasured = std::numeric_limits<double>::quiet_NaN();

/// Degrees of elevation, found less true.
struct Errors
{
  double Bias = NotMeasured;
  double Rmse = NotMeasured;
  double Percentile999 = NotMeasured; ///< of the absolute error, nearest rank
  double Largest = NotMeasured;       ///< absolute
  double Samples = NotMeasured;       ///< posts x azimuths compared
};

/// Nanoseconds are for one post and azimuth on one core, the smallest or median of the repeats.
struct Result
{
  bool Ran = false;
  char Reason[160] = ""; ///< why it did not run, or what to know about the row
  Errors Error;
  double PrepareNs = NotMeasured; ///< CPU time of the thread, smallest
  double SearchNs = NotMeasured;  ///< likewise
  double TotalNs = NotMeasured;   ///< likewise, of one repeat
  double TotalMedianNs = NotMeasured;
  double WallNs = NotMeasured;
  double WallMedianNs = NotMeasured;
  double FloatsPerPost = NotMeasured; ///< peak resident memory beyond the input
  double BuildSeconds = NotMeasured;  ///< CPU, of what is built once for all azimuths
  double SkyViewRmse = NotMeasured;   ///< of SkyViewFactor
};

static_assert(std::is_trivially_copyable_v<Result>, "a Result travels through a pipe");

} // namespace benchmark
} // namespace skyline

#endif
