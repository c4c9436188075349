// SPDX-License-Identifier: BSD-3-Clause
// The base height, above which heights are stored as floats.
#ifndef skyline_BaseHeight_h
#define skyline_BaseHeight_h

#include "Shared/HeightLimits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace skyline
{

/// Metres of relief up to which the base height may lie halfway between the lowest and the highest
/// post. Floats then resolve heights to 0.5 mm.
constexpr double PlainRelief = 1.0e4;

/// The base height for posts whose finite heights lie between `lowest` and `highest`: halfway
/// between the two, or, if they are further apart than PlainRelief, the median of a sample of the
/// posts. A few posts of 1e20, whatever they mean, then do not cost the other posts their digits.
/// height(i): metres of post i of `count`; not finite if it is missing. The same posts always give
/// the same base height.
template <typename Height>
double BaseHeight(std::ptrdiff_t count, double lowest, double highest, const Height& height)
{
  lowest = std::clamp(lowest, -GreatestHeight, GreatestHeight);
  highest = std::clamp(highest, -GreatestHeight, GreatestHeight);
  const double middle = lowest + 0.5 * (highest - lowest);
  if (highest - lowest <= PlainRelief)
  {
    return middle;
  }
  constexpr std::ptrdiff_t wanted = 1 << 16;
  const std::ptrdiff_t step =
    std::max<std::ptrdiff_t>(1, count / wanted) | 1; // odd, so that samples lie in all columns
  std::vector<double> sample;
  for (std::ptrdiff_t i = 0; i < count; i += step)
  {
    const double one = height(i);
    if (std::abs(one) < GreatestHeight)
    {
      sample.push_back(one);
    }
  }
  if (sample.empty())
  {
    return middle;
  }
  const auto median = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::nth_element(sample.begin(), median, sample.end());
  return *median;
}

} // namespace skyline

#endif
