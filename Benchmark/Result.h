// SPDX-License-Identifier: BSD-3-Clause
// The result of measuring one method on one scene.
#ifndef skyline_Result_h
#define skyline_Result_h

#include <limits>
#include <type_traits>

namespace skyline
{
namespace benchmark
{

constexpr double NotMeasured = std::numeric_limits<double>::quiet_NaN();

/// The computed value minus the reference value: degrees of elevation, or the unit of the quantity.
struct Errors
{
  double Bias = NotMeasured;
  double Rmse = NotMeasured;
  double Percentile999 = NotMeasured; ///< of the absolute error, nearest rank
  double Largest = NotMeasured;       ///< absolute
  double Samples = NotMeasured;       ///< number of compared posts x azimuths, or values
};

/// Nanoseconds are per post and azimuth on one core, the smallest or the median of the repeats.
struct Result
{
  bool Ran = false;
  char Reason[160] = ""; ///< why the method did not run, or a remark on the row
  Errors Error;
  double PrepareNs = NotMeasured; ///< CPU time of the thread, smallest
  double SearchNs = NotMeasured;  ///< likewise
  double TotalNs = NotMeasured;   ///< likewise, sum of both in one repeat
  double TotalMedianNs = NotMeasured;
  double WallNs = NotMeasured;
  double WallMedianNs = NotMeasured;
  double FloatsPerPost = NotMeasured; ///< peak resident memory beyond the input
  double BuildSeconds = NotMeasured;  ///< CPU time of what is built once for all azimuths
  double SkyViewRmse = NotMeasured;   ///< error of SkyViewFactor
  double ColdNs = NotMeasured;        ///< CPU time of the first repeat
  double Repeats = NotMeasured;       ///< number of repeats
  double Threads = 1.0;
  double WrongPercent = NotMeasured; ///< lit posts that are dark in the reference, and reverse
  double Similarity = NotMeasured;   ///< SSIM of the picture; 1 means identical
  double RelightNs = NotMeasured;    ///< CPU time per post after a change of the light alone
};

static_assert(std::is_trivially_copyable_v<Result>, "a Result is sent through a pipe");

} // namespace benchmark
} // namespace skyline

#endif
