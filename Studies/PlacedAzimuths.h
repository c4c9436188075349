// SPDX-License-Identifier: BSD-3-Clause
// An experiment: azimuths that are placed where horizons vary. The light is that of a uniform sky.
#ifndef skyline_PlacedAzimuths_h
#define skyline_PlacedAzimuths_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace skyline
{
namespace testing
{

/// The light of a uniform sky in each of many evenly spaced azimuths, divided by their mean.
using AzimuthLight = std::vector<double>;

/// The light that a level or tilted post gets in one azimuth of a uniform sky, above the elevation
/// `horizon`.
inline double UniformLight(double horizon, double azimuth, double east, double north)
{
  const double rise = east * std::sin(azimuth) + north * std::cos(azimuth);
  const double e = std::max({ horizon, std::atan(rise), 0.0 });
  const double c = std::cos(e);
  return (0.5 * c * c - 0.5 * rise * (std::acos(std::sin(e)) - std::sin(e) * c)) /
    std::sqrt(1.0 + east * east + north * north);
}

/// Chooses `count` azimuths for the light of the given posts. Half of them are evenly spaced. Then
/// the interval is halved whose ends differ most (the mean over the posts times the width), and so
/// on.
inline std::vector<std::size_t> PlaceAzimuths(
  const std::vector<const AzimuthLight*>& posts, std::size_t count)
{
  using Interval = std::pair<double, std::pair<std::size_t, std::size_t>>;
  const std::size_t all = posts.front()->size();
  const auto worth = [&](std::size_t begin, std::size_t end)
  {
    double sum = 0.0;
    for (const AzimuthLight* light : posts)
    {
      sum += std::abs((*light)[begin] - (*light)[end % all]);
    }
    return end - begin < 2 ? -1.0 : sum * static_cast<double>(end - begin);
  };
  std::priority_queue<Interval> intervals;
  const std::size_t step = all / (count / 2);
  for (std::size_t begin = 0; begin < all; begin += step)
  {
    intervals.push({ worth(begin, begin + step), { begin, begin + step } });
  }
  while (intervals.size() < count)
  {
    const auto [begin, end] = intervals.top().second;
    intervals.pop();
    const std::size_t middle = (begin + end) / 2;
    intervals.push({ worth(begin, middle), { begin, middle } });
    intervals.push({ worth(middle, end), { middle, end } });
  }
  std::vector<std::size_t> azimuths;
  for (; !intervals.empty(); intervals.pop())
  {
    azimuths.push_back(intervals.top().second.first);
  }
  std::sort(azimuths.begin(), azimuths.end());
  return azimuths;
}

/// The relative error of the light of a post in percent, if each azimuth represents the range
/// halfway to its neighbours.
inline double PlacedError(const AzimuthLight& light, const std::vector<std::size_t>& azimuths)
{
  const auto all = static_cast<double>(light.size());
  double sum = 0.0;
  for (std::size_t k = 0; k < azimuths.size(); ++k)
  {
    const double before =
      k > 0 ? static_cast<double>(azimuths[k - 1]) : static_cast<double>(azimuths.back()) - all;
    const double after = k + 1 < azimuths.size() ? static_cast<double>(azimuths[k + 1])
                                                 : static_cast<double>(azimuths.front()) + all;
    sum += light[azimuths[k]] * 0.5 * (after - before);
  }
  return 100.0 * std::abs(sum / all - 1.0);
}

} // namespace testing
} // namespace skyline

#endif
