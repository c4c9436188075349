// SPDX-License-Identifier: BSD-3-Clause
#include "GroundPatches.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skyline
{
namespace
{

/// Lines along which the metric is followed, evenly spread over the other side.
constexpr std::ptrdiff_t Traces = 9;

/// How far the metric has moved along each trace up to a post, in units of the tolerances.
class Path
{
public:
  /// along: true for the columns' side (posts counted from west to east).
  Path(const GroundMetric& metric, bool columns, double azimuth, double scale)
    : Posts(columns ? metric.Columns() : metric.Rows())
  {
    const std::ptrdiff_t others = columns ? metric.Rows() : metric.Columns();
    for (std::ptrdiff_t trace = 0; trace < Traces; ++trace)
    {
      const double other = static_cast<double>(trace * (others - 1)) / (Traces - 1.0);
      std::array<std::vector<double>, 2>& sums = this->Moved[static_cast<std::size_t>(trace)];
      PostMetric before;
      for (std::ptrdiff_t post = 0; post < this->Posts; ++post)
      {
        const auto here = static_cast<double>(post);
        const PostMetric now = columns ? metric.At(here, other) : metric.At(other, here);
        if (post == 0)
        {
          sums[0].push_back(0.0);
          sums[1].push_back(0.0);
        }
        else
        {
          const MetricError error = ErrorOf(before, now);
          sums[0].push_back(sums[0].back() + error.Azimuth / azimuth);
          sums[1].push_back(sums[1].back() + error.Distance / scale);
        }
        before = now;
      }
    }
  }

  /// The longest way from one post to another over all traces.
  double Between(std::ptrdiff_t first, std::ptrdiff_t last) const
  {
    double longest = 0.0;
    for (const auto& trace : this->Moved)
    {
      for (const std::vector<double>& sums : trace)
      {
        longest = std::max(
          longest, sums[static_cast<std::size_t>(last)] - sums[static_cast<std::size_t>(first)]);
      }
    }
    return longest;
  }

  double Whole() const { return this->Between(0, this->Posts - 1); }

  std::ptrdiff_t Posts;

private:
  std::array<std::array<std::vector<double>, 2>, Traces> Moved;
};

/// Cuts a side into runs of which no post is further than `reach` from the run's middle.
std::vector<PatchSide> Cut(const Path& path, double reach)
{
  std::vector<PatchSide> sides;
  for (std::ptrdiff_t begin = 0; begin < path.Posts;)
  {
    // Twice the reach from end to end; found by halving, since the way only grows.
    std::ptrdiff_t low = begin, high = path.Posts - 1;
    while (low < high)
    {
      const std::ptrdiff_t middle = low + (high - low + 1) / 2;
      const bool fits = path.Between(begin, middle) <= 2.0 * reach;
      low = fits ? middle : low;
      high = fits ? high : middle - 1;
    }
    PatchSide side;
    side.Begin = begin;
    side.End = low + 1;
    // Halfway along the way, not along the posts.
    std::ptrdiff_t middle = begin;
    while (middle + 1 < side.End && path.Between(begin, middle + 1) <= path.Between(middle + 1, low))
    {
      ++middle;
    }
    side.Middle = static_cast<double>(middle);
    if (path.Between(begin, low) == 0.0)
    {
      side.Middle = 0.5 * static_cast<double>(begin + low);
    }
    sides.push_back(side);
    begin = side.End;
  }
  return sides;
}

/// Widens neighbours into each other and gives them weights.
void Blend(std::vector<PatchSide>& sides)
{
  struct Ramp
  {
    double Border, Reach; // posts
  };
  std::vector<Ramp> ramps;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
  {
    const std::ptrdiff_t narrower =
      std::min(sides[i].End - sides[i].Begin, sides[i + 1].End - sides[i + 1].Begin);
    ramps.push_back({ static_cast<double>(sides[i].End) - 0.5,
      std::min(static_cast<double>(BlendPosts), 0.5 * static_cast<double>(narrower)) });
  }
  for (std::size_t i = 0; i < sides.size() && sides.size() > 1; ++i)
  {
    PatchSide& side = sides[i];
    if (i > 0)
    {
      side.Begin = static_cast<std::ptrdiff_t>(std::floor(ramps[i - 1].Border - ramps[i - 1].Reach)) + 1;
    }
    if (i + 1 < sides.size())
    {
      side.End = static_cast<std::ptrdiff_t>(std::ceil(ramps[i].Border + ramps[i].Reach));
    }
    for (std::ptrdiff_t post = side.Begin; post < side.End; ++post)
    {
      double weight = 1.0;
      const auto rise = [&](const Ramp& ramp)
      {
        return std::clamp(
          0.5 + 0.5 * (static_cast<double>(post) - ramp.Border) / ramp.Reach, 0.0, 1.0);
      };
      weight *= i > 0 ? rise(ramps[i - 1]) : 1.0;
      weight *= i + 1 < sides.size() ? 1.0 - rise(ramps[i]) : 1.0;
      side.Weights.push_back(static_cast<float>(weight));
    }
  }
}

} // namespace

GroundPatches DivideGround(const GroundMetric& metric, double azimuthTolerance, double scaleTolerance)
{
  GroundPatches patches;
  patches.Columns.push_back({ 0, metric.Columns(), 0.5 * static_cast<double>(metric.Columns() - 1), {} });
  patches.Rows.push_back({ 0, metric.Rows(), 0.5 * static_cast<double>(metric.Rows() - 1), {} });
  if (metric.Uniform())
  {
    return patches;
  }
  const Path across(metric, true, azimuthTolerance, scaleTolerance);
  const Path along(metric, false, azimuthTolerance, scaleTolerance);
  // A side that needs less than half of the tolerance stays whole and leaves the rest to the other.
  const double halfAcross = 0.5 * across.Whole(), halfAlong = 0.5 * along.Whole();
  if (halfAcross + halfAlong <= 1.0)
  {
    return patches;
  }
  if (halfAcross > 0.5)
  {
    patches.Columns = Cut(across, halfAlong <= 0.5 ? 1.0 - halfAlong : 0.5);
    Blend(patches.Columns);
  }
  if (halfAlong > 0.5)
  {
    patches.Rows = Cut(along, halfAcross <= 0.5 ? 1.0 - halfAcross : 0.5);
    Blend(patches.Rows);
  }
  return patches;
}

} // namespace skyline
