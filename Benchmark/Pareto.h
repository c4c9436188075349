// SPDX-License-Identifier: BSD-3-Clause
// Which findings no other one beats, and what the ratios of a session are.
#ifndef skyline_Pareto_h
#define skyline_Pareto_h

#include "Job.h"

#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// Whether a finding has both coordinates of a chart.
bool OnChart(const Finding& finding);

/// Whether a takes no more time and has no more error than b, and less of one.
bool Beats(const Finding& a, const Finding& b);

/// Those of one chart that no other beats, from the quickest to the most exact. Pointers into
/// `findings`.
std::vector<const Finding*> Front(const std::vector<const Finding*>& findings);

/// The findings of a quantity on a scene that are on its chart.
std::vector<const Finding*> ChartOf(
  const std::vector<Finding>& findings, const std::string& quantity, const std::string& scene);

/// A method of the papers that neither exact nor fast beats somewhere.
struct Exception
{
  const Finding* Paper = nullptr;
  const Finding* Nearest = nullptr; ///< the quickest of ours with no more error; null: none
  const Finding* Alike = nullptr;   ///< exact with the same settings, if it ran
  bool Tie = false;                 ///< Nearest's quickest run was no slower: the clock's scatter
};
/// Sweep and pyramid of a quantity that were measured where exact or fast was too.
std::size_t ComparedWithPapers(const std::vector<Finding>& findings, const std::string& quantity);

std::vector<Exception> Exceptions(const std::vector<Finding>& findings);

/// How many times faster; on a scene.
struct Ratio
{
  std::string Name; ///< "exact over every crossing"
  std::string Scene;
  double Times = 0.0;
};

/// Of horizons: exact over every crossing, Embree at 0.25 degrees, GRASS and the papers' methods, fast
/// over exact.
std::vector<Ratio> Ratios(const std::vector<Finding>& findings);

} // namespace benchmark
} // namespace skyline

#endif
