// SPDX-License-Identifier: BSD-3-Clause
// Fields for which all filters must work: extremes of shape, height, spacing, size and missing
// posts.
#ifndef skyline_StabilityScenes_h
#define skyline_StabilityScenes_h

#include "Reference/Shapes.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <ostream>
#include <vector>

namespace skyline
{
namespace testing
{

struct StabilityScene
{
  const char* Name;
  std::function<oracle::OracleField()> Make;
};

// How ctest prints a scene.
inline void PrintTo(const StabilityScene& scene, std::ostream* out)
{
  *out << scene.Name;
}

inline oracle::OracleField Stretched(oracle::OracleField field, double x, double y)
{
  field.SpacingX *= x;
  field.SpacingY *= y;
  return field;
}

inline oracle::OracleField Raised(oracle::OracleField field, double metres)
{
  for (double& height : field.Heights)
  {
    height += metres;
  }
  return field;
}

/// Hills in which each seventh post has one of these values, in turn.
inline oracle::OracleField HillsWithValues(const std::vector<double>& values)
{
  oracle::OracleField field = shapes::Fractal(29, 23, 30.0, 600.0, 7);
  for (std::size_t post = 3; post < field.Heights.size(); post += 7)
  {
    field.Heights[post] = values[(post / 7) % values.size()];
  }
  return field;
}

/// A field of missing posts, with `size` x `size` posts of hills in the middle.
inline oracle::OracleField Island(std::ptrdiff_t size)
{
  oracle::OracleField field = shapes::Fractal(21, 19, 30.0, 600.0, 3);
  for (std::ptrdiff_t j = 0; j < field.Rows; ++j)
  {
    for (std::ptrdiff_t i = 0; i < field.Columns; ++i)
    {
      if (i < 9 || i >= 9 + size || j < 8 || j >= 8 + size)
      {
        field.At(i, j) = std::nan("");
      }
    }
  }
  return field;
}

/// Every other post is missing, so that all others have no surface.
inline oracle::OracleField Chessboard()
{
  oracle::OracleField field = shapes::Fractal(18, 17, 30.0, 600.0, 5);
  for (std::size_t post = 0; post < field.Heights.size(); ++post)
  {
    const std::size_t column = post % 18, row = post / 18;
    field.Heights[post] = (column + row) % 2 == 0 ? field.Heights[post] : std::nan("");
  }
  return field;
}

inline const std::vector<StabilityScene>& StabilityScenes()
{
  using namespace shapes;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  static const std::vector<StabilityScene> scenes{
    { "Flat", [] { return Plane(24, 20, 30.0, 0.0, 0.0); } },
    { "InclinedPlane", [] { return Plane(25, 21, 30.0, 0.4, -0.7); } },
    { "NearlyLevelNormals", [] { return Plane(20, 20, 1.0, 3.0e4, 1.0e4); } },
    { "VValley", [] { return Valley(25, 21, 10.0, 1.2); } },
    { "Pit", [] { return CylinderPit(25, 25, 1.0, 4.5, 20.0); } },
    { "ConicalPit", [] { return ConicalPit(25, 25, 1.0, 9.0, 2.0); } },
    { "Trench", [] { return Trench(25, 21, 1.0, 6.0, 2); } },
    { "Wall", [] { return Wall(25, 21, 1.0, 8.0, 12, 1); } },
    { "SpikeOfTenThousandSpacings", [] { return Spike(25, 23, 1.0, 1.0e4, 11, 13); } },
    { "SpikeDown", [] { return Spike(25, 23, 1.0, -1.0e4, 11, 13); } },
    { "CliffOfAMillion", [] { return Cliff(23, 25, 1.0, 1.0e6, 12); } },
    { "MillimetresOnTenThousandKilometres",
      [] { return Raised(Fractal(24, 22, 1.0, 0.02, 4), 1.0e7); } },
    { "BelowSeaLevel", [] { return Raised(Fractal(24, 22, 100.0, 900.0, 4), -11000.0); } },
    { "SpacingOfAMicrometre", [] { return Fractal(24, 22, 1.0e-6, 2.0e-5, 4); } },
    { "SpacingOfAThousandKilometres", [] { return Fractal(24, 22, 1.0e6, 9000.0, 4); } },
    { "ThousandTimesWider", [] { return Stretched(Fractal(24, 22, 30.0, 600.0, 4), 1e3, 1.0); } },
    { "ThousandTimesLonger", [] { return Stretched(Fractal(24, 22, 30.0, 600.0, 4), 1.0, 1e3); } },
    { "TwoByTwo", [] { return Fractal(2, 2, 30.0, 90.0, 4); } },
    { "TwoByMany", [] { return Fractal(2, 67, 30.0, 300.0, 4); } },
    { "ManyByTwo", [] { return Fractal(67, 2, 30.0, 300.0, 4); } },
    { "PrimeSizes", [] { return Fractal(37, 31, 30.0, 600.0, 4); } },
    { "NotANumber", [] { return HillsWithValues({ std::nan("") }); } },
    { "Infinities",
      [] {
        return HillsWithValues({ infinite, -infinite, std::nan("") });
      } },
    { "MissingIslands",
      []
      {
        oracle::OracleField field = Fractal(37, 31, 30.0, 900.0, 9);
        RemoveIslands(field, 9, 4, 2);
        return field;
      } },
    { "OneCellLeft", [] { return Island(2); } },
    { "OnePostLeft", [] { return Island(1); } },
    { "NoCellLeft", Chessboard },
    // Elevations so close to +90 and -90 degrees that a float cannot represent the difference.
    { "HorizonsOfNinetyDegrees", [] { return Trench(25, 21, 1.0e-6, 1.0e6, 1); } },
    { "HorizonsOfMinusNinetyDegrees", [] { return Spike(25, 23, 1.0e-6, 1.0e6, 12, 11); } },
    { "RoundBody",
      []
      {
        oracle::OracleField field = Fractal(24, 22, 2000.0, 900.0, 4);
        field.CurvatureDrop = 1.0e-6; // a body with a radius of 500 km
        return field;
      } },
    { "HousesAndHoles",
      []
      {
        oracle::OracleField field = RandomBoxes(37, 31, 1.0, 25, 6, 20.0, 3);
        RemoveIslands(field, 4, 2, 2);
        return field;
      } },
  };
  return scenes;
}

inline bool AnyMissing(const oracle::OracleField& field)
{
  for (const double height : field.Heights)
  {
    if (!std::isfinite(height))
    {
      return true;
    }
  }
  return false;
}

/// Rounds the heights to floats, as in an array of floats.
inline oracle::OracleField AsFloats(oracle::OracleField field)
{
  for (double& height : field.Heights)
  {
    height = static_cast<float>(height);
  }
  return field;
}

} // namespace testing
} // namespace skyline

#endif
