// SPDX-License-Identifier: BSD-3-Clause
// Finds the results that no other result beats, and the ratios between the methods.
#ifndef skyline_Pareto_h
#define skyline_Pareto_h

#include "Job.h"

#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// True if a finding has both coordinates of a chart.
bool OnChart(const Finding& finding);

/// True if `a` takes no more time and has no greater error than `b`, and is better in at least one.
bool Beats(const Finding& a, const Finding& b);

/// The findings of one chart that no other finding beats, from the fastest to the most exact, as
/// pointers into `findings`.
std::vector<const Finding*> Front(const std::vector<const Finding*>& findings);

/// The findings of a quantity on a scene that have a point in its chart.
std::vector<const Finding*> ChartOf(
  const std::vector<Finding>& findings, const std::string& quantity, const std::string& scene);

/// A result of a published method (sweep or pyramid) that neither exact nor fast beats.
struct Exception
{
  const Finding* Paper = nullptr;
  const Finding* Nearest = nullptr; ///< the fastest of ours with no greater error; null: none
  const Finding* Alike = nullptr;   ///< exact with the same settings, if it ran
  bool Tie = false;                 ///< equal within scatter: Nearest's fastest run was no slower
};
/// The number of results of sweep and pyramid that can be compared with exact or fast.
std::size_t ComparedWithPapers(const std::vector<Finding>& findings, const std::string& quantity);

std::vector<Exception> Exceptions(const std::vector<Finding>& findings);

/// How many times faster one method is than another, on a scene.
struct Ratio
{
  std::string Name; ///< "exact over every crossing"
  std::string Scene;
  double Times = 0.0;
};

/// For horizons: exact compared with every crossing, Embree at 0.25 degrees, GRASS and the
/// published methods; fast compared with exact.
std::vector<Ratio> Ratios(const std::vector<Finding>& findings);

} // namespace benchmark
} // namespace skyline

#endif
