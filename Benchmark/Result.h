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

/// Found less true: degrees of elevation, or what the quantity has as its unit.
struct Errors
{
  double Bias = NotMeasured;
  double Rmse = NotMeasured;
  double Percentile999 = NotMeasured; ///< of the absolute error, nearest rank
  double Largest = NotMeasured;       ///< absolute
  double Samples = NotMeasured;       ///< posts x azimuths, or values, compared
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
  double ColdNs = NotMeasured;        ///< CPU, of the first repeat
  double Repeats = NotMeasured;       ///< how many there were
  double Threads = 1.0;
  double WrongPercent = NotMeasured; ///< posts lit where the truth is dark, and the reverse
  double Similarity = NotMeasured;   ///< SSIM of the picture, 1: alike
  double RelightNs = NotMeasured;    ///< CPU, a post, after the light alone has changed
};

static_assert(std::is_trivially_copyable_v<Result>, "a Result travels through a pipe");

} // namespace benchmark
} // namespace skyline

#endif
