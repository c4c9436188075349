// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"
#include "Harmonics/SphericalHarmonics.h"
#include "Reference/VisibilityWedge.h"

#include "vtkExecutive.h"
#include "vtkHeightFieldSkyView.h"
#include "vtkHeightFieldTransfer.h"
#include "vtkHeightFieldVisibility.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>

namespace skyline
{
namespace testing
{
namespace
{

oracle::OracleField Hills()
{
  oracle::OracleField field = shapes::Fractal(131, 97, 30.0, 1500.0, 7);
  shapes::RemoveIslands(field, 5, 4, 3);
  return field;
}

// All steps from heights to coefficients, compared with the oracle's horizons in double precision.
TEST(VisibilityFilter, ProjectsTheHorizonsOfTheOracle)
{
  const oracle::OracleField field = Hills();
  vtkNew<vtkHeightFieldVisibility> filter;
  filter->SetInputData(ImageOf<vtkDoubleArray>(field));
  filter->SetNumberOfAzimuths(10);
  filter->SetNumberOfBands(5);
  filter->Update();
  vtkFloatArray* found = ArrayOf(filter, "VisibilitySH");
  ASSERT_NE(found, nullptr);
  ASSERT_EQ(found->GetNumberOfComponents(), 25);
  ASSERT_EQ(found->GetNumberOfTuples(), 131 * 97);
  for (std::ptrdiff_t row = 0; row < field.Rows; row += 12)
  {
    for (std::ptrdiff_t column = 0; column < field.Columns; column += 5)
    {
      const vtkIdType post = row * field.Columns + column;
      if (!field.HasPost(column, row))
      {
        EXPECT_TRUE(std::isnan(found->GetComponent(post, 3)));
        continue;
      }
      double truth[25] = {}, wedge[25];
      for (int k = 0; k < 10; ++k)
      {
        const double slope = oracle::HorizonSlope(field, column, row, 2.0 * Pi * k / 10.0);
        StepWedge(5, 2.0 * Pi * k / 10.0, 2.0 * Pi / 10.0, std::max(0.0, std::atan(slope)), wedge);
        for (int c = 0; c < 25; ++c)
        {
          truth[c] += wedge[c];
        }
      }
      for (int c = 0; c < 25; ++c)
      {
        EXPECT_NEAR(found->GetComponent(post, c), truth[c], 5.0e-5); // heights in floats: 1e-5 rad
      }
    }
  }
}

TEST(TransferFilter, UniformSkyIsTheSkyViewFactor)
{
  const auto image = ImageOf<vtkFloatArray>(Hills());
  vtkNew<vtkHeightFieldTransfer> transfer;
  transfer->SetInputData(image);
  transfer->SetNumberOfAzimuths(36);
  transfer->Update();
  vtkNew<vtkHeightFieldSkyView> sky;
  sky->SetInputData(image);
  sky->SetNumberOfAzimuths(36);
  sky->Update();
  vtkFloatArray* coefficients = ArrayOf(transfer, "TransferSH");
  vtkFloatArray* factor = ArrayOf(sky, "SkyViewFactor");
  ASSERT_EQ(coefficients->GetNumberOfComponents(), 16);
  for (vtkIdType post = 0; post < factor->GetNumberOfTuples(); ++post)
  {
    const double irradiance = std::sqrt(4.0 * Pi) * coefficients->GetComponent(post, 0);
    if (std::isnan(factor->GetValue(post)))
    {
      EXPECT_TRUE(std::isnan(irradiance));
      continue;
    }
    ASSERT_NEAR(irradiance, Pi * factor->GetValue(post), 1.0e-5);
  }
}

TEST(VisibilityFilter, SwathIsAPartOfTheCircle)
{
  const auto image = ImageOf<vtkFloatArray>(Hills());
  // 4 azimuths around 40 degrees: the middles of their swaths are at 27, 36, 45 and 54 degrees.
  vtkNew<vtkHeightFieldVisibility> part;
  part->SetInputData(image);
  part->SetNumberOfAzimuths(4);
  part->SetSwathAzimuth(40.5);
  part->SetSwathWidth(36.0);
  part->Update();
  double sums[16] = {};
  const vtkIdType post = 50 * 131 + 60;
  const oracle::OracleField field = Hills();
  for (int k = 0; k < 4; ++k)
  {
    const double azimuth = (27.0 + 9.0 * k) * RadiansPerDegree;
    const double slope = oracle::HorizonSlope(field, 60, 50, azimuth);
    double wedge[16];
    StepWedge(4, azimuth, 9.0 * RadiansPerDegree, std::max(0.0, std::atan(slope)), wedge);
    for (int c = 0; c < 16; ++c)
    {
      sums[c] += wedge[c];
    }
  }
  for (int c = 0; c < 16; ++c)
  {
    EXPECT_NEAR(ArrayOf(part, "VisibilitySH")->GetComponent(post, c), sums[c], 1.0e-5);
  }
}

TEST(VisibilityFilter, GivesTheSameBitsOnAnyNumberOfThreads)
{
  const auto image = ImageOf<vtkFloatArray>(Hills());
  std::vector<float> first;
  for (int threads = 1; threads <= 8; threads += 3)
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]()
      {
        vtkNew<vtkHeightFieldTransfer> filter;
        filter->SetInputData(image);
        filter->SetNumberOfAzimuths(9);
        filter->Update();
        vtkFloatArray* array = ArrayOf(filter, "TransferSH");
        const std::vector<float> bits(
          array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues());
        first = first.empty() ? bits : first;
        ASSERT_EQ(first.size(), bits.size());
        EXPECT_EQ(std::memcmp(first.data(), bits.data(), bits.size() * sizeof(float)), 0);
      });
  }
}

TEST(VisibilityFilter, TakesThePyramid)
{
  vtkNew<vtkHeightFieldVisibility> filter;
  filter->SetInputData(ImageOf<vtkFloatArray>(shapes::EggTray(64, 64, 10.0, 60.0, 320.0)));
  filter->SetMethodToPyramid();
  filter->Update();
  double range[2];
  ArrayOf(filter, "VisibilitySH")->GetRange(range, 0);
  EXPECT_GT(range[0], 0.2);
  EXPECT_LT(range[1], HemisphereZonal(0) + 1.0e-6);
  EXPECT_LT(range[0], range[1] - 0.2);
}

TEST(VisibilityFilter, UnchangedHeightsKeepTheirPyramid)
{
  const auto image = ImageOf<vtkFloatArray>(Hills());
  vtkNew<vtkHeightFieldVisibility> filter;
  filter->SetInputData(image);
  filter->SetMethodToPyramid();
  filter->SetNumberOfAzimuths(3);
  const auto builds = [&]()
  {
    filter->Update();
    return filter->GetPyramidBuilds();
  };
  EXPECT_EQ(builds(), 1);
  // Another swath, another number of bands, other settings for reading the levels, and a call of
  // Modified alone.
  filter->SetSwathWidth(20.0);
  EXPECT_EQ(builds(), 0);
  filter->SetNumberOfBands(3);
  EXPECT_EQ(builds(), 0);
  filter->SetLevelOffset(1.0);
  filter->SetLevelDistance(1.5);
  filter->LevelSplineOff();
  EXPECT_EQ(builds(), 0);
  image->GetPointData()->GetScalars()->Modified();
  image->Modified();
  EXPECT_EQ(builds(), 0);
  const auto same = [&]()
  {
    vtkNew<vtkHeightFieldVisibility> fresh;
    fresh->SetInputData(image);
    fresh->SetMethodToPyramid();
    fresh->SetNumberOfAzimuths(3);
    fresh->SetSwathWidth(20.0);
    fresh->SetNumberOfBands(3);
    fresh->SetLevelStep(filter->GetLevelStep());
    fresh->SetLevelOffset(1.0);
    fresh->SetLevelDistance(1.5);
    fresh->LevelSplineOff();
    fresh->Update();
    vtkFloatArray* kept = ArrayOf(filter, "VisibilitySH");
    vtkFloatArray* built = ArrayOf(fresh, "VisibilitySH");
    return std::memcmp(kept->GetPointer(0), built->GetPointer(0),
             static_cast<std::size_t>(kept->GetNumberOfValues()) * sizeof(float)) == 0;
  };
  EXPECT_TRUE(same());
  // Other levels; other heights, with and without a call of Modified; a post that becomes missing;
  // a run of another method in between.
  filter->SetLevelStep(3.0);
  EXPECT_EQ(builds(), 1);
  EXPECT_TRUE(same());
  vtkDataArray* heights = image->GetPointData()->GetScalars();
  heights->SetComponent(777, 0, heights->GetComponent(777, 0) + 0.01);
  image->Modified();
  EXPECT_EQ(builds(), 1);
  EXPECT_TRUE(same());
  heights->SetComponent(5000, 0, std::nan(""));
  heights->Modified();
  image->Modified();
  EXPECT_EQ(builds(), 1);
  EXPECT_TRUE(same());
  filter->SetMethodToExact();
  EXPECT_EQ(builds(), 0);
  filter->SetMethodToPyramid();
  EXPECT_EQ(builds(), 1);
}

TEST(VisibilityFilter, RefusesWhatItCannotDo)
{
  const auto refuses =
    [](const std::function<void(vtkHeightFieldVisibility*)>& change, const std::string& reason)
  {
    vtkNew<vtkHeightFieldVisibility> filter;
    vtkNew<ErrorCatcher> errors;
    errors->Watch(filter);
    vtkNew<ErrorCatcher> executive;
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executive);
    filter->SetInputData(ImageOf<vtkFloatArray>(shapes::Plane(8, 8, 1.0, 0.0, 0.0)));
    change(filter);
    filter->Update();
    EXPECT_EQ(errors->Count, 1);
    EXPECT_NE(errors->Text.find(reason), std::string::npos) << errors->Text;
    EXPECT_EQ(ArrayOf(filter, "VisibilitySH"), nullptr);
  };
  for (const int bands : { 1, 9 })
  {
    refuses([&](auto* f) { f->SetNumberOfBands(bands); }, "give 2 to 8");
  }
  for (const int azimuths : { 0, 3601 })
  {
    refuses([&](auto* f) { f->SetNumberOfAzimuths(azimuths); }, "azimuths; give 1 to 3600");
  }
  for (const double width : { 0.0, -1.0, 360.1, std::nan("") })
  {
    refuses([&](auto* f) { f->SetSwathWidth(width); }, "give more than 0 and at most 360");
  }
  refuses([](auto* f) { f->SetSwathAzimuth(std::nan("")); }, "the swath's azimuth");
  refuses(
    [](auto* f)
    {
      f->SetMethodToPyramid();
      f->SetLevelStep(0.0);
    },
    "levels per octave");
}

} // namespace
} // namespace testing
} // namespace skyline
