// SPDX-License-Identifier: BSD-3-Clause
// The errors of the horizons of the pyramid, compared with the exact ones. Prints the table of
// Documentation/sn08.md.
#include "Reference/OracleTerrain.h"
#include "Testing/Module/RealTerrain.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <utility>

namespace skyline
{
namespace testing
{
namespace
{

constexpr int Azimuths = 12;

struct Error
{
  double Rmse = 0.0, Bias = 0.0, Largest = 0.0; // degrees
};

/// Elevations above 0, because the pyramid has no others.
std::vector<float> Elevations(
  const oracle::OracleField& field, const HeightField& posts, const HorizonSettings& settings)
{
  const auto method = MakeHorizonMethod(posts, settings);
  std::vector<float> elevations;
  for (int k = 0; k < Azimuths; ++k)
  {
    for (const float slope : Slopes(*method, GridOf(field), 360.0 * (k + 0.3) / Azimuths))
    {
      elevations.push_back(static_cast<float>(std::max(0.0, Elevation(slope))));
    }
  }
  return elevations;
}

Error Compare(const std::vector<float>& found, const std::vector<float>& truth)
{
  double squares = 0.0, sum = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const double error = static_cast<double>(found[i]) - static_cast<double>(truth[i]);
    squares += error * error;
    sum += error;
    largest = std::max(largest, std::abs(error));
  }
  const auto count = static_cast<double>(found.size());
  return { std::sqrt(squares / count), sum / count, largest };
}

/// Errors by (k, o) with the spline, and by (-4, o) without it, which is computed for k = 4 only.
std::map<std::pair<int, int>, Error> Table(const char* name, const oracle::OracleField& field)
{
  const HeightField posts = FieldOf(field);
  const std::vector<float> truth = Elevations(field, posts, HorizonSettings());
  std::map<std::pair<int, int>, Error> errors;
  for (const int k : { 1, 2, 4, -4, 8 })
  {
    for (const int o : { 0, 1, 2, 3, 4, 8 })
    {
      HorizonSettings settings;
      settings.Method = HorizonMethodKind::Pyramid;
      settings.Pyramid.LevelStep = std::abs(k);
      settings.Pyramid.LevelOffset = o;
      settings.Pyramid.Spline = k > 0;
      const Error error = Compare(Elevations(field, posts, settings), truth);
      errors[{ k, o }] = error;
      std::printf("%-12s k = %d%s  o = %d  rmse %6.3f  bias %+6.3f  largest %6.2f degrees\n", name,
        std::abs(k), k > 0 ? "     " : " max ", o, error.Rmse, error.Bias, error.Largest);
    }
  }
  return errors;
}

// SN08, figures 3, 4 and 10: with larger k and o the errors decrease. The bounds are 10 % above the
// measured values.
TEST(PyramidError, OfFractalHills)
{
  // The slopes of a relief of 1500 m on 1024 posts.
  auto errors = Table("fractal", shapes::Fractal(256, 256, 30.0, 375.0, 1));
  EXPECT_LT((errors[{ 4, 2 }].Rmse), 1.5);
  EXPECT_LT((errors[{ 8, 8 }].Rmse), (errors[{ 4, 4 }].Rmse));
  EXPECT_LT((errors[{ 4, 4 }].Rmse), (errors[{ 2, 2 }].Rmse));
  EXPECT_LT((errors[{ 2, 2 }].Rmse), (errors[{ 1, 1 }].Rmse));
}

TEST(PyramidError, OfSaintHelens)
{
  const oracle::OracleField field = SaintHelens();
  ASSERT_EQ(field.Columns, 160);
  auto errors = Table("St Helens", field);
  EXPECT_LT((errors[{ 4, 2 }].Rmse), 2.7);
  EXPECT_LT((errors[{ 8, 8 }].Rmse), (errors[{ 4, 4 }].Rmse));
  EXPECT_LT((errors[{ 4, 4 }].Rmse), (errors[{ 2, 2 }].Rmse));
  EXPECT_LT((errors[{ 2, 2 }].Rmse), (errors[{ 1, 1 }].Rmse));
}

} // namespace
} // namespace testing
} // namespace skyline
