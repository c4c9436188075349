// SPDX-License-Identifier: BSD-3-Clause
// The scenes of the figures 6.1 to 6.5 of THESIS, each with its lamps.
#ifndef skyline_ThesisScenes_h
#define skyline_ThesisScenes_h

#include "Reference/LampOracle.h"
#include "Reference/Shapes.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace skyline
{
namespace testing
{

struct ThesisScene
{
  const char* Name;
  const char* Figure;
  oracle::OracleField Field;
  std::vector<oracle::Ball> Lamps;
};

/// The scenes with n x n posts over 256 m; the thesis uses n = 256.
inline std::vector<ThesisScene> ThesisScenes(std::ptrdiff_t n)
{
  const double spacing = 256.0 / static_cast<double>(n - 1);
  const auto posts = [&](double metres)
  { return static_cast<std::ptrdiff_t>(std::lround(metres / spacing)); };
  return {
    { "city", "6.3a", shapes::City(n, n, spacing, posts(20.0), posts(12.0), 40.0),
      { { { 70.0, 70.0, 25.0 }, 4.0 }, { { 166.0, 102.0, 20.0 }, 4.0 },
        { { 134.0, 198.0, 50.0 }, 6.0 } } },
    { "cones v1", "6.3c", shapes::ConesInRows(n, n, spacing, 22.0, 40.0),
      { { { 96.0, 96.0, 20.0 }, 6.0 }, { { 160.0, 160.0, 30.0 }, 6.0 } } },
    { "cones v2", "6.1, 6.2, 6.3e", shapes::ConesOnCircle(n, n, spacing, 24.0, 36.0),
      { { { 128.0, 128.0, 16.0 }, 8.0 } } },
    { "eggtray", "6.4a", shapes::EggTray(n, n, spacing, 14.0, 90.0),
      { { { 128.0, 128.0, 26.0 }, 6.0 }, { { 50.0, 190.0, 26.0 }, 6.0 } } },
    { "mountain", "6.4d", shapes::Fractal(n, n, spacing, 90.0, 6),
      { { { 70.0, 80.0, 75.0 }, 6.0 }, { { 180.0, 90.0, 80.0 }, 6.0 },
        { { 130.0, 190.0, 90.0 }, 8.0 } } },
    { "sine grating", "6.4e", shapes::SineGrating(n, n, spacing, 12.0, 64.0),
      { { { 112.0, 128.0, 12.0 }, 5.0 }, { { 176.0, 60.0, 20.0 }, 5.0 } } },
    { "teddy", "6.5a", shapes::Teddy(n, n, spacing, 40.0),
      { { { 40.0, 210.0, 50.0 }, 8.0 }, { { 216.0, 200.0, 50.0 }, 8.0 },
        { { 128.0, 20.0, 60.0 }, 8.0 } } },
  };
}

} // namespace testing
} // namespace skyline

#endif
