// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/SharedSwaths.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>

namespace skyline
{

namespace
{

struct Span
{
  double Begin, End; // radians; End is at most Begin + 2 pi
  std::vector<std::size_t> Lights;
};

Swath SwathBetween(double begin, double end)
{
  return { ModuloCircle(0.5 * (begin + end)), std::min(end - begin, Circle) };
}

} // namespace

std::vector<SharedSwath> ShareSwaths(const std::vector<KeyLight>& lights)
{
  std::vector<Span> spans;
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    const Swath swath = SwathOf(lights[i]);
    const double begin = ModuloCircle(swath.Azimuth - 0.5 * swath.Width);
    spans.push_back({ begin, begin + swath.Width, { i } });
  }
  std::sort(
    spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.Begin < b.Begin; });
  std::vector<Span> joined;
  const auto join = [](Span& into, const Span& from, double turn)
  {
    into.End = std::max(into.End, from.End + turn);
    into.Lights.insert(into.Lights.end(), from.Lights.begin(), from.Lights.end());
  };
  for (const Span& span : spans)
  {
    if (!joined.empty() && span.Begin <= joined.back().End)
    {
      join(joined.back(), span, 0.0);
    }
    else
    {
      joined.push_back(span);
    }
  }
  // The last swaths may extend across north into the first.
  while (joined.size() > 1 && joined.back().End - Circle >= joined.front().Begin)
  {
    join(joined.back(), joined.front(), Circle);
    joined.erase(joined.begin());
  }
  std::vector<SharedSwath> shared;
  for (Span& span : joined)
  {
    std::sort(span.Lights.begin(), span.Lights.end());
    shared.push_back({ SwathBetween(span.Begin, span.End), span.Lights });
  }
  return shared;
}

} // namespace skyline
