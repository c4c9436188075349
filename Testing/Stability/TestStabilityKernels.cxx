// SPDX-License-Identifier: BSD-3-Clause
// All kernels for horizons and light on all extreme fields: results must be within the bounds of
// the oracle, energy must be conserved, and there must be no invalid operation, overflow or
// division by zero.
#include "FloatGuard.h"
#include "Harmonics/VisibilityAccumulator.h"
#include "HeightField/Normals.h"
#include "Horizon/StoreAccumulator.h"
#include "HorizonBounds.h"
#include "Lamps/LampIrradiance.h"
#include "ShadowHeight/ShadowHeight.h"
#include "ShadowHeight/ShadowHeightSweep.h"
#include "Sky/LightAccumulator.h"
#include "Sky/SkyAccumulator.h"
#include "StabilityScenes.h"
#include "Sun/SunAccumulator.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

// Multiples of 45 degrees, both sides of them and of north, and other azimuths.
const std::vector<double> Azimuths{ 0.0, 0.01, 26.565051177, 45.0, 77.0, 90.0, 135.0, 180.0, 191.0,
  225.0, 270.0, 315.0, 341.0, 359.99, 405.0, -90.0 };

class StabilityOfKernels : public ::testing::TestWithParam<StabilityScene>
{
protected:
  void SetUp() override
  {
    this->Field = GetParam().Make();
    this->Settings.CurvatureDrop = this->Field.CurvatureDrop;
  }
  std::size_t Posts() const { return this->Field.Heights.size(); }
  bool Missing(std::size_t post) const { return !std::isfinite(this->Field.Heights[post]); }

  oracle::OracleField Field;
  HorizonSettings Settings;
};

TEST_P(StabilityOfKernels, HorizonsAreThoseOfTheOracle)
{
  const HeightField posts = FieldOf(this->Field);
  std::vector<std::vector<double>> truth;
  for (const double azimuth : Azimuths)
  {
    truth.push_back(oracle::HorizonSlopes(this->Field, azimuth));
  }
  for (const TestedMethod& tested : TestedMethods())
  {
    this->Settings.Method = tested.Kind;
    this->Settings.Tolerance = tested.Kind == HorizonMethodKind::Exact ? tested.Tolerance : 0.0;
    std::vector<std::vector<float>> found;
    std::string raised;
    {
      const FloatGuard guard;
      const auto method = MakeHorizonMethod(posts, this->Settings);
      for (const double azimuth : Azimuths)
      {
        found.push_back(Slopes(*method, GridOf(this->Field), azimuth));
      }
      raised = guard.Raised();
    }
    EXPECT_EQ(raised, "") << tested.Name;
    for (std::size_t k = 0; k < Azimuths.size(); ++k)
    {
      ASSERT_EQ(FirstComplaint(this->Field, tested, found[k], truth[k]), "")
        << "azimuth " << Azimuths[k];
    }
  }
}

// Only the methods exact and fast support the surface of bilinear cells.
TEST_P(StabilityOfKernels, BilinearHorizonsAreThoseOfTheOracle)
{
  this->Field.Through = Surface::Bilinear;
  this->Settings.Shape = Surface::Bilinear;
  const HeightField posts = FieldOf(this->Field);
  const TestedMethod& exact = TestedMethods().front();
  for (const double azimuth : { 13.0, 45.0, 100.0, 225.0, 300.0 })
  {
    std::vector<float> found;
    std::string raised;
    {
      const FloatGuard guard;
      found = Slopes(*MakeHorizonMethod(posts, this->Settings), GridOf(this->Field), azimuth);
      raised = guard.Raised();
    }
    EXPECT_EQ(raised, "");
    ASSERT_EQ(
      FirstComplaint(this->Field, exact, found, oracle::HorizonSlopes(this->Field, azimuth)), "")
      << "azimuth " << azimuth;
  }
}

/// The light that results from the horizons of a field, computed under a FloatGuard.
struct Lit
{
  static constexpr int Count = 24; ///< azimuths
  std::vector<float> Sky, Level, Fraction, Openness, Ambient, Suns[4], White, Visibility, Transfer;
};

Lit Light(const oracle::OracleField& field, const HorizonSettings& settings)
{
  const HeightField posts = FieldOf(field);
  const Grid grid = GridOf(field);
  const std::size_t count = field.Heights.size();
  std::vector<float> east(count), north(count);
  Gradients(
    grid, [&](std::ptrdiff_t i, std::ptrdiff_t j) { return field.At(i, j); }, 0, grid.Rows,
    east.data(), north.data());
  Lit lit;
  for (std::vector<float>* values :
    { &lit.Sky, &lit.Level, &lit.Fraction, &lit.Openness, &lit.Ambient })
  {
    values->resize(count);
  }
  SkyBuffers buffers;
  buffers.SkyViewFactor.Values = lit.Sky.data();
  buffers.SkyViewFactorHorizontal.Values = lit.Level.data();
  buffers.VisibleSkyFraction.Values = lit.Fraction.data();
  buffers.PositiveOpenness.Values = lit.Openness.data();
  buffers.UniformAmbient.Values = lit.Ambient.data();
  SkyAccumulator sky(grid.Columns, buffers, east.data(), north.data());

  const std::vector<float> white(3 * 8 * 4, 1.0f);
  std::vector<double> azimuths;
  for (int k = 0; k < Lit::Count; ++k)
  {
    azimuths.push_back(2.0 * Pi * k / Lit::Count);
  }
  lit.White.resize(3 * count);
  LightAccumulator light(grid.Columns, grid.Rows, { { ViewTopDown(white.data(), 8, 4) } }, azimuths,
    LightAccumulator::Options(), east.data(), north.data(), lit.White.data());
  lit.Visibility.resize(16 * count);
  lit.Transfer.resize(16 * count);
  VisibilityAccumulator visibility({ grid.Columns, grid.Rows, 4, lit.Visibility.data() });
  VisibilityAccumulator transfer(
    { grid.Columns, grid.Rows, 4, lit.Transfer.data() }, east.data(), north.data());
  const auto method = MakeHorizonMethod(posts, settings);
  const auto feed = [&](const std::vector<double>& at, std::vector<Accumulator*> consumers)
  {
    for (const double azimuth : at)
    {
      const std::vector<float> slopes = Slopes(*method, grid, azimuth * DegreesPerRadian);
      for (Accumulator* consumer : consumers)
      {
        consumer->Begin(azimuth, 2.0 * Pi / static_cast<double>(at.size()));
        for (std::ptrdiff_t row = 0; row < grid.Rows; ++row)
        {
          consumer->Add(row, 0, grid.Columns, slopes.data() + row * grid.Columns);
        }
      }
    }
    for (Accumulator* consumer : consumers)
    {
      consumer->Finish(0, grid.Rows);
    }
  };
  feed(azimuths, { &sky, &light, &visibility, &transfer });
  // Across north: below the plane, on it, above it, and at the zenith.
  const double elevations[4] = { -0.2, 0.0, 0.6, 0.5 * Pi };
  for (int k = 0; k < 4; ++k)
  {
    lit.Suns[k].resize(count);
    PostBuffer buffer;
    buffer.Values = lit.Suns[k].data();
    const double azimuth = 359.95 * RadiansPerDegree, radius = MeanSunRadius * RadiansPerDegree;
    SunAccumulator sun(
      grid.Columns, grid.Rows, SunDisc{ azimuth, elevations[k], radius }, buffer, 0.6);
    feed(SunAzimuths(azimuth, azimuth, elevations[k], elevations[k], radius), { &sun });
  }
  return lit;
}

/// w^2 / 24 for a swath of this number of azimuths: the difference between the mean of a cosine
/// over it and the cosine in its middle.
constexpr double SwathShare = Pi * Pi / (6.0 * Lit::Count * Lit::Count);

/// The sum of the squared coefficients of a post.
double Energy(const std::vector<float>& harmonics, std::size_t post)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < 16; ++k)
  {
    const double c = harmonics[16 * post + k];
    sum += c * c;
  }
  return sum;
}

TEST_P(StabilityOfKernels, LightConservesEnergy)
{
  constexpr double sums = 1.0e-5; // of two dozen floats up to 1, and of the arcs of vectors
  for (const HorizonMethodKind kind : { HorizonMethodKind::Exact, HorizonMethodKind::Fast,
         HorizonMethodKind::Sweep, HorizonMethodKind::Pyramid })
  {
    SCOPED_TRACE("method " + std::to_string(static_cast<int>(kind)));
    this->Settings.Method = kind;
    Lit lit;
    if (AnyMissing(this->Field))
    {
      lit = Light(this->Field, this->Settings); // NaN gives NaN, and its comparisons are "invalid"
    }
    else
    {
      const FloatGuard guard;
      lit = Light(this->Field, this->Settings);
      EXPECT_EQ(guard.Raised(), "");
    }
    const auto within = [](double value, double low, double high, double slack)
    { return value >= low - slack && value <= high + slack; };
    for (std::size_t post = 0; post < this->Posts(); ++post)
    {
      if (this->Missing(post))
      {
        ASSERT_TRUE(std::isnan(lit.Sky[post])) << post;
        ASSERT_TRUE(std::isnan(lit.White[3 * post])) << post;
        continue;
      }
      ASSERT_TRUE(within(lit.Sky[post], 0.0, 1.0, sums)) << lit.Sky[post];
      ASSERT_TRUE(within(lit.Level[post], 0.0, 1.0, sums)) << lit.Level[post];
      ASSERT_TRUE(within(lit.Fraction[post], 0.0, 1.0, sums)) << lit.Fraction[post];
      ASSERT_TRUE(within(lit.Openness[post], 0.0, 180.0, 1.0e-3)) << lit.Openness[post];
      ASSERT_TRUE(within(lit.Ambient[post], 0.0, 1.05, sums)) << lit.Ambient[post];
      for (const auto& sun : lit.Suns)
      {
        ASSERT_TRUE(within(sun[post], 0.0, 1.0, 0.0)) << sun[post];
      }
      ASSERT_EQ(lit.Suns[0][post], 0.0f) << "the sun has set";
      // A white sky gives the sky view factor times pi. The table uses the mean of the cosine over
      // a swath instead of the cosine in its middle: less by w^2 / 24 of the light from the side.
      ASSERT_NEAR(lit.White[3 * post], Pi * lit.Sky[post], Pi * SwathShare);
      ASSERT_EQ(lit.White[3 * post], lit.White[3 * post + 1]);
      ASSERT_EQ(lit.White[3 * post], lit.White[3 * post + 2]);
      // Bessel's inequality: the energy of a series is at most that of its function, 1 on half of
      // the sphere or the cosine there.
      ASSERT_TRUE(within(Energy(lit.Visibility, post), 0.0, 2.0 * Pi, 1e-4));
      ASSERT_TRUE(within(Energy(lit.Transfer, post), 0.0, 2.0 / 3.0 * Pi, 1e-4));
    }
  }
}

TEST_P(StabilityOfKernels, LampsGiveNoMoreThanAllAround)
{
  const HeightField posts = FieldOf(this->Field);
  const LampTerrain terrain(posts);
  const Grid grid = GridOf(this->Field);
  std::vector<float> east(this->Posts()), north(this->Posts());
  Gradients(
    grid, [&](std::ptrdiff_t i, std::ptrdiff_t j) { return this->Field.At(i, j); }, 0, grid.Rows,
    east.data(), north.data());
  LampSettings settings;
  settings.CurvatureDrop = this->Field.CurvatureDrop;
  settings.Azimuths = 8;
  const double width = grid.SpacingX * static_cast<double>(grid.Columns);
  const double relief = ReliefOf(this->Field);
  // Above the ground, on it, and below it; inside and outside the field; small, as large as the
  // field, and much larger.
  for (const double height : { 2.0 * relief + width, 0.0, -2.0 * relief - width })
  {
    for (const double radius : { 0.0, 1e-6 * width, 0.3 * width, 1e4 * width })
    {
      for (const double place : { 0.5, -3.0 })
      {
        Lamp lamp;
        lamp.X = place * width;
        lamp.Y = 0.5 * grid.SpacingY * static_cast<double>(grid.Rows - 1);
        lamp.Z = height;
        lamp.Radius = radius;
        std::vector<float> rgb(3 * this->Posts(), 0.0f);
        AddLampIrradiance(
          terrain, grid, east.data(), north.data(), lamp, settings, 0, grid.Rows, rgb.data());
        for (std::size_t post = 0; post < this->Posts(); ++post)
        {
          const float light = rgb[3 * post];
          ASSERT_EQ(std::isnan(light), this->Missing(post));
          ASSERT_TRUE(this->Missing(post) || (light >= 0.0f && light <= 1.0001 * Pi)) << light;
          ASSERT_TRUE(radius > 0.0 || this->Missing(post) || light == 0.0f) << light;
        }
      }
    }
  }
}

TEST_P(StabilityOfKernels, ShadowHeightsSayWhatHorizonsSay)
{
  const HeightField posts = FieldOf(this->Field);
  const double base = BaseOf(this->Field);
  for (const double elevation : { 0.0, 20.0, 89.99 })
  {
    const double slope = ShadowSlope(elevation * RadiansPerDegree);
    for (const double azimuth : { 0.0, 45.0, 100.0, 333.0 })
    {
      std::vector<float> heights, swept;
      std::string raised;
      {
        const FloatGuard guard;
        ShadowHeightExact exact(posts, slope, this->Field.CurvatureDrop);
        heights = Slopes(exact, GridOf(this->Field), azimuth);
        ShadowHeightSweep sweep(posts, slope);
        swept = Slopes(sweep, GridOf(this->Field), azimuth);
        raised = guard.Raised();
      }
      EXPECT_EQ(raised, "") << elevation << " " << azimuth;
      const std::vector<double> truth = oracle::HorizonSlopes(this->Field, azimuth);
      for (std::size_t post = 0; post < this->Posts(); ++post)
      {
        if (this->Missing(post))
        {
          continue;
        }
        ASSERT_TRUE(std::isfinite(heights[post]) && std::isfinite(swept[post]));
        // A post is in shadow (by more than the rounding) if and only if its horizon is above the
        // light.
        const double own = this->Field.Heights[post] - base;
        const double step = std::min(this->Field.SpacingX, this->Field.SpacingY);
        const double rounding = 1.0e-6 * (ReliefOf(this->Field) + std::abs(heights[post]));
        const double turn = SlopeRounding(this->Field, truth[post]) + rounding / step;
        if (heights[post] > own + rounding)
        {
          ASSERT_GT(truth[post], slope - turn) << elevation << " " << azimuth << " " << post;
        }
        if (truth[post] > slope + turn)
        {
          ASSERT_GT(heights[post], own - rounding) << elevation << " " << azimuth << " " << post;
        }
        ASSERT_LE(swept[post], ReliefOf(this->Field) * (1.0 + 1e-5)) << post;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, StabilityOfKernels, ::testing::ValuesIn(StabilityScenes()),
  [](const auto& scene) { return std::string(scene.param.Name); });

// A kernel gets such a field only if no filter refused it.
TEST(StabilityOfNothing, AllMissing)
{
  oracle::OracleField none(7, 5, 1.0, 1.0);
  for (double& height : none.Heights)
  {
    height = std::nan("");
  }
  HeightField posts(GridOf(none));
  posts.Fill(0, 5, 0.0, [](std::ptrdiff_t, std::ptrdiff_t) { return std::nan(""); });
  posts.Close();
  posts.Transpose();
  for (const TestedMethod& tested : TestedMethods())
  {
    HorizonSettings settings;
    settings.Method = tested.Kind;
    const FloatGuard guard;
    const auto method = MakeHorizonMethod(posts, settings);
    for (const double azimuth : Azimuths)
    {
      EXPECT_EQ(Slopes(*method, GridOf(none), azimuth).size(), 35u);
    }
    EXPECT_EQ(guard.Raised(), "") << tested.Name;
  }
}

} // namespace
} // namespace testing
} // namespace skyline
