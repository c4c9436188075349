// SPDX-License-Identifier: BSD-3-Clause
#include "Shared/NearName.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace skyline
{

namespace
{

// The number of letters that must be inserted, deleted, changed or swapped with a neighbour to
// convert one word to the other.
std::size_t Distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> before;
  std::vector<std::size_t> last(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{ 0 });
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::vector<std::size_t> row(b.size() + 1, i);
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({ row[j - 1] + 1, last[j] + 1, change });
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
      {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before = std::exchange(last, row);
  }
  return last[b.size()];
}

} // namespace

std::string Nearest(const std::string& word, const std::vector<std::string>& names)
{
  std::string best;
  // A third of the letters may be wrong: "skyview" matches sky-view, and "--colours" matches
  // --colors.
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& name : names)
  {
    const std::size_t distance = Distance(word, name);
    // An abbreviation matches, however many letters are missing.
    const bool start = word.size() >= 3 && name.rfind(word, 0) == 0;
    if (std::min(distance, start ? std::size_t{ 1 } : distance) < least)
    {
      least = start ? 1 : distance;
      best = name;
    }
  }
  return best;
}

std::string DidYouMean(const std::string& word, const std::vector<std::string>& names)
{
  const std::string name = Nearest(word, names);
  return name.empty() ? "" : "; did you mean " + name + "?";
}

} // namespace skyline
