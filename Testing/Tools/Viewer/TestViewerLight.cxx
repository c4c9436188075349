// SPDX-License-Identifier: BSD-3-Clause
// The parts of the viewer's light that need no window: twilight, exposure, moving lamps, skies.
#include "Exposure.h"
#include "LampPreview.h"
#include "Lamps/Lamp.h"
#include "Sky/ZonalSky.h"
#include "SkyImage.h"
#include "Twilight.h"
#include "ViewerState.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cmath>

namespace skyline
{
namespace
{

// The polynomials agree to a hundredth of a power of ten.
constexpr double LogarithmTolerance = 0.011;

// The error of floats, summed over single posts.
constexpr double FloatTolerance = 1.0e-5;

// A flat field with posts 10 m apart and a wall across column 30.
vtkSmartPointer<vtkImageData> Wall(double height)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(61, 41, 1);
  image->SetSpacing(10.0, 10.0, 1.0);
  image->SetOrigin(1000.0, 2000.0, 0.0);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Elevation");
  for (int row = 0; row < 41; ++row)
  {
    for (int column = 0; column < 61; ++column)
    {
      heights->InsertNextValue(static_cast<float>(column == 30 ? height : 0.0));
    }
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

ViewerLamp LampAt(double x, double y)
{
  ViewerLamp lamp;
  lamp.X = x;
  lamp.Y = y;
  lamp.Radius = 5.0;
  lamp.Radiance = { { 3.0, 2.0, 1.0 } };
  return lamp;
}

TEST(Twilight, HasTheValuesOfItsTable)
{
  EXPECT_NEAR(std::log10(TwilightIlluminance(0.0)), 2.88, LogarithmTolerance);
  EXPECT_NEAR(TwilightIlluminance(-6.0), 3.4, 0.05);
  EXPECT_NEAR(TwilightIlluminance(-12.0), 0.008, 0.0002);
  EXPECT_NEAR(TwilightIlluminance(-18.0), 0.00065, 0.00001);
  EXPECT_EQ(TwilightShare(45.0), 1.0);
  EXPECT_EQ(TwilightShare(-90.0), TwilightShare(-18.0));
  EXPECT_EQ(TwilightShare(std::nan("")), 1.0);
}

TEST(Twilight, FallsWithoutAStep)
{
  for (double elevation = 0.0; elevation > -19.0; elevation -= 0.01)
  {
    const double before = std::log10(TwilightIlluminance(elevation));
    const double after = std::log10(TwilightIlluminance(elevation - 0.01));
    EXPECT_LT(after, before + LogarithmTolerance) << elevation;
    EXPECT_NEAR(after, before, 2.0 * LogarithmTolerance) << elevation;
  }
}

TEST(Exposure, FollowsTheDayAndLetsNightBeDark)
{
  EXPECT_EQ(AdaptedStops(-3.0), -3.0);
  EXPECT_EQ(AdaptedStops(FullAdaptation), FullAdaptation);
  const double night = -std::log2(TwilightShare(-18.0)) + FullAdaptation;
  EXPECT_GT(night - AdaptedStops(night), 3.0);
  EXPECT_LT(night - AdaptedStops(night), 5.0);
}

TEST(Exposure, IsKeptByItsKey)
{
  ViewerState state;
  state.MeteredStops = 7.0;
  EXPECT_EQ(state.Stops(), 7.0);
  state.Press('A', {});
  state.MeteredStops = 1.0;
  EXPECT_EQ(state.Stops(), 7.0);
  state.Press('=', {});
  EXPECT_GT(state.Stops(), 7.0);
  state.Press('-', {});
  state.Press('A', {});
  EXPECT_NEAR(state.Stops(), 1.0, 1.0e-12);
}

TEST(LampPreview, OnAPlaneIsExact)
{
  const LampPreview preview(Wall(0.0));
  const ViewerLamp lamp = LampAt(1303.0, 2196.0);
  const auto light = preview.Light(lamp, 40.0);
  for (int row = 0; row < 41; ++row)
  {
    for (int column = 0; column < 61; ++column)
    {
      const double distance = std::sqrt(
        std::pow(1303.0 - 1000.0 - 10.0 * column, 2) + std::pow(196.0 - 10.0 * row, 2) + 1600.0);
      const double exact = DiscIrradiance(DiscOfLamp(5.0, distance), 40.0 / distance);
      EXPECT_NEAR(light->GetComponent(61 * row + column, 0), 3.0 * exact, FloatTolerance);
      EXPECT_NEAR(light->GetComponent(61 * row + column, 2), exact, FloatTolerance);
    }
  }
}

// The centre of the lamp at z = 20 is 100 m west of a wall 12 m high: its shadow ends at 250 m.
TEST(LampPreview, WallsThrowShadowsWithAPenumbra)
{
  const LampPreview preview(Wall(12.0));
  const auto seen = preview.Visibility(LampAt(1200.0, 2200.0), 20.0);
  const auto at = [&](int column) { return seen[static_cast<std::size_t>(61 * 20 + column)]; };
  EXPECT_EQ(at(25), 1.0f);
  EXPECT_EQ(at(32), 0.0f);
  EXPECT_NEAR(at(45), 0.5f, FloatTolerance);
  // 25 and 15 m, the top and the bottom of the lamp, give 192 and 500 m from the lamp: there none
  // or all of it is visible.
  EXPECT_EQ(at(20 + 19), 0.0f);
  EXPECT_NEAR(at(20 + 39), 0.5 + 0.5 * (20.0 - 12.0 * 390.0 / 290.0) / 5.0, FloatTolerance);
  for (int column = 33; column < 61; ++column)
  {
    EXPECT_GE(at(column), at(column - 1));
  }
}

TEST(LampPreview, TakesAnyPlaceAndMissingPosts)
{
  const auto field = Wall(12.0);
  vtkDataArray* heights = field->GetPointData()->GetScalars();
  heights->SetComponent(61 * 20 + 25, 0, std::nan(""));
  const LampPreview preview(field);
  for (const auto& place : { std::array<double, 2>{ { 1000.0, 2000.0 } },
         std::array<double, 2>{ { 1250.0, 2200.0 } }, std::array<double, 2>{ { -9.0e5, 7.0e5 } } })
  {
    const auto light = preview.Light(LampAt(place[0], place[1]), 1.0);
    for (vtkIdType k = 0; k < light->GetNumberOfValues(); ++k)
    {
      EXPECT_TRUE(std::isfinite(light->GetValue(k))) << k;
    }
  }
}

constexpr Rgb White{ { 1.0f, 1.0f, 1.0f } };

TerrainLight Under(const std::string& sky)
{
  TerrainLight light;
  light.Sky = ParseSky(sky, true);
  return light;
}

TEST(SkyImage, FormulasHaveTheLevelAskedFor)
{
  for (const std::string name : { "uniform", "cie:1", "cie:3", "cie:16" })
  {
    const Rgb level{ { 1.0f, 2.0f, 3.0f } };
    const SkyImage sky = MakeSkyImage(Under(name), level, level);
    // The irradiance of level ground divided by pi: the mean with the weights sine times solid
    // angle.
    double sum = 0.0;
    for (std::ptrdiff_t row = 0; row < sky.Rows / 2; ++row)
    {
      const double top = std::sin(M_PI * static_cast<double>(row) / static_cast<double>(sky.Rows));
      const double low =
        std::sin(M_PI * static_cast<double>(row + 1) / static_cast<double>(sky.Rows));
      const auto pixel = static_cast<std::size_t>(3 * row * sky.Columns);
      sum += sky.Values[pixel + 1] * (low * low - top * top);
    }
    EXPECT_NEAR(sum, 2.0, 0.001) << name; // rows of one degree
  }
}

TEST(SkyImage, GradientIsTheFormula)
{
  const SkyImage sky = MakeSkyImage(Under("cie:1"), White, White);
  const auto row = [&](std::ptrdiff_t k)
  { return sky.Values[static_cast<std::size_t>(3 * k * sky.Columns)]; };
  const double polar = 0.5 * M_PI / static_cast<double>(sky.Rows);
  const std::ptrdiff_t half = sky.Rows / 2;
  EXPECT_NEAR(row(half - 1) / row(0),
    ZonalSky::Radiance(1, std::sin(polar)) / ZonalSky::Radiance(1, std::cos(polar)), 1.0e-5);
  EXPECT_NEAR(row(half) / row(half - 1), 1.0, 0.15) << "no step at the horizon";
  EXPECT_NEAR(row(sky.Rows - 1), PlainAlbedo[0], 0.001);
}

} // namespace
} // namespace skyline
