// SPDX-License-Identifier: BSD-3-Clause
// Compares the filter with vtkHeightFieldSunShadow: the same posts must be in shadow.
#include "FilterTesting.h"

#include "vtkFieldData.h"
#include "vtkHeightFieldReader.h"
#include "vtkHeightFieldShadowHeight.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

// Azimuths on both sides of the axes and diagonals: all octants and their limits.
const std::vector<double> Azimuths{ 0.0, 20.0, 45.0, 65.0, 90.0, 110.0, 135.0, 155.0, 180.0, 200.0,
  225.0, 245.0, 270.0, 290.0, 315.0, 335.0 };

vtkSmartPointer<vtkImageData> StHelens()
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(SKYLINE_TEST_DATA "/exact/sthelens_crop160_dem.tif");
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkImageData> Houses()
{
  return ImageOf<vtkFloatArray>(shapes::RandomBoxes(200, 180, 0.5, 60, 20, 12.0, 5));
}

vtkSmartPointer<vtkImageData> WithHoles()
{
  oracle::OracleField field = shapes::Fractal(150, 170, 30.0, 1500.0, 8);
  shapes::RemoveIslands(field, 25, 6, 2);
  return ImageOf<vtkDoubleArray>(field);
}

struct Count
{
  std::size_t Posts = 0, Dark = 0, Different = 0;
};

// Compares the posts whose shadow height lies above them with those that the other filter finds
// dark.
Count Compare(vtkImageData* image, double azimuth, double elevation)
{
  vtkNew<vtkHeightFieldSunShadow> sun;
  sun->SetInputData(image);
  sun->SetSunAzimuth(azimuth);
  sun->SetSunElevation(elevation);
  sun->SetSunAngularRadius(0.0);
  sun->Update();
  vtkNew<vtkHeightFieldShadowHeight> map;
  map->SetInputData(image);
  map->SetSunAzimuth(azimuth);
  map->SetSunElevation(elevation);
  map->Update();
  vtkFloatArray* visibility = ArrayOf(sun, "SunVisibility");
  vtkFloatArray* shadow = ArrayOf(map, "ShadowHeight");
  vtkDataArray* heights = image->GetPointData()->GetScalars();
  Count count;
  for (vtkIdType post = 0; post < image->GetNumberOfPoints(); ++post)
  {
    EXPECT_EQ(std::isnan(visibility->GetValue(post)), std::isnan(shadow->GetValue(post))) << post;
    if (!std::isnan(shadow->GetValue(post)))
    {
      const auto ground = static_cast<float>(heights->GetComponent(post, 0));
      EXPECT_GE(shadow->GetValue(post), ground);
      const bool dark = shadow->GetValue(post) > ground;
      ++count.Posts;
      count.Dark += dark;
      count.Different += dark != (visibility->GetValue(post) == 0.0f);
    }
  }
  return count;
}

// No post is left out, not even at the edge of the data or beside missing posts. Only a post whose
// horizon touches the sun to the last digit of a float may differ, because one filter compares
// slopes and the other heights.
constexpr double Grazing = 1.0e-4;

void ExpectTheSamePosts(vtkImageData* image, double elevation)
{
  Count all;
  for (const double azimuth : Azimuths)
  {
    const Count count = Compare(image, azimuth, elevation);
    all.Posts += count.Posts;
    all.Dark += count.Dark;
    all.Different += count.Different;
    EXPECT_GT(count.Dark, 0u) << azimuth;
    EXPECT_LE(
      static_cast<double>(count.Different), Grazing * static_cast<double>(count.Posts) + 1.0)
      << azimuth;
  }
  ::testing::Test::RecordProperty("posts", std::to_string(all.Posts));
  ::testing::Test::RecordProperty("dark", std::to_string(all.Dark));
  ::testing::Test::RecordProperty("different", std::to_string(all.Different));
}

TEST(HeightFieldShadowHeight, DarkensThePostsThatSeeNoSunOnStHelens)
{
  ExpectTheSamePosts(StHelens(), 13.0); // with the Earth's curvature
}

TEST(HeightFieldShadowHeight, DarkensThePostsThatSeeNoSunAmongHouses)
{
  ExpectTheSamePosts(Houses(), 27.0);
}

TEST(HeightFieldShadowHeight, DarkensThePostsThatSeeNoSunBesideMissingOnes)
{
  ExpectTheSamePosts(WithHoles(), 17.0);
}

TEST(HeightFieldShadowHeight, DoesNotDependOnThreads)
{
  const auto image = WithHoles();
  for (const int method : { vtkHeightFieldShadowHeight::EXACT, vtkHeightFieldShadowHeight::SWEEP })
  {
    std::vector<float> first;
    for (const int threads : { 1, 2, 7 })
    {
      vtkNew<vtkHeightFieldShadowHeight> map;
      map->SetInputData(image);
      map->SetMethod(method);
      map->SetSunAzimuth(73.0);
      map->SetSunElevation(12.0);
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&] { map->Update(); });
      vtkFloatArray* shadow = ArrayOf(map, "ShadowHeight");
      std::vector<float> values;
      for (vtkIdType post = 0; post < shadow->GetNumberOfTuples(); ++post)
      {
        const float value = shadow->GetValue(post);
        values.push_back(std::isnan(value) ? -1.0f : value);
      }
      first = first.empty() ? values : first;
      EXPECT_EQ(values, first) << threads;
    }
  }
}

// A ridge of 100 m in the east of a plain at 500 m, with the sun behind the ridge.
vtkSmartPointer<vtkImageData> Ridge()
{
  oracle::OracleField field = shapes::Plane(201, 31, 2.0, 0.0, 0.0);
  for (std::ptrdiff_t row = 0; row < field.Rows; ++row)
  {
    field.At(200, row) = 100.0;
  }
  return ImageOf<vtkDoubleArray>(field, 500.0);
}

constexpr vtkIdType RidgeRow = 15 * 201;
constexpr double Metre = 1e-3; // floats near 600 m

TEST(HeightFieldShadowHeight, LimbsOfARidge)
{
  vtkNew<vtkHeightFieldShadowHeight> map;
  map->SetInputData(Ridge());
  map->SetSunAzimuth(90.0);
  map->SetSunElevation(20.0);
  map->SetSunAngularRadius(0.5);
  map->SoftOn();
  map->Update();
  const auto tangent = [](double degrees) { return std::tan(degrees * RadiansPerDegree); };
  for (const vtkIdType column : { 60, 100, 150, 190 })
  {
    const double distance = 2.0 * static_cast<double>(200 - column);
    const auto expected = [&](double degrees)
    { return 500.0 + std::max(100.0 - distance * tangent(degrees), -2.0 * tangent(degrees)); };
    const vtkIdType post = RidgeRow + column;
    EXPECT_NEAR(
      ArrayOf(map, "ShadowHeight")->GetValue(post), std::max(expected(20.0), 500.0), Metre);
    EXPECT_NEAR(ArrayOf(map, "ShadowHeightUpper")->GetValue(post), expected(20.5), Metre);
    EXPECT_NEAR(ArrayOf(map, "ShadowHeightLower")->GetValue(post), expected(19.5), Metre);
  }
  // There is no terrain beyond the last column, so its shadow height is its own height.
  EXPECT_EQ(ArrayOf(map, "ShadowHeightUpper")->GetValue(RidgeRow + 200), 600.0f);
  vtkDataArray* sun = map->GetOutput()->GetFieldData()->GetArray("ShadowSun");
  ASSERT_NE(sun, nullptr);
  EXPECT_EQ(sun->GetComponent(0, 0), 90.0);
  EXPECT_EQ(sun->GetComponent(0, 1), 20.0);
  EXPECT_EQ(sun->GetComponent(0, 2), 0.5);

  map->SoftOff();
  map->BelowTerrainOn();
  map->Update();
  EXPECT_EQ(ArrayOf(map, "ShadowHeightUpper"), nullptr);
  EXPECT_NEAR(ArrayOf(map, "ShadowHeight")->GetValue(RidgeRow), 500.0 - 2.0 * tangent(20.0), Metre);
}

TEST(HeightFieldShadowHeight, SunsThatHaveNotRisen)
{
  vtkNew<vtkHeightFieldShadowHeight> map;
  map->SetInputData(WithHoles());
  map->SetSunElevation(-0.1);
  map->SoftOn();
  map->Update();
  vtkFloatArray* hard = ArrayOf(map, "ShadowHeight");
  vtkFloatArray* upper = ArrayOf(map, "ShadowHeightUpper");
  vtkFloatArray* lower = ArrayOf(map, "ShadowHeightLower");
  for (vtkIdType post = 0; post < hard->GetNumberOfTuples(); ++post)
  {
    if (!std::isnan(hard->GetValue(post)))
    {
      ASSERT_EQ(hard->GetValue(post), std::numeric_limits<float>::infinity());
      ASSERT_LE(upper->GetValue(post), lower->GetValue(post));
      ASSERT_TRUE(std::isfinite(lower->GetValue(post)));
    }
  }
  map->SetSunElevation(90.0);
  map->SetInputData(StHelens());
  map->Update();
  EXPECT_TRUE(std::isfinite(ArrayOf(map, "ShadowHeightUpper")->GetRange()[0]));
}

std::string ErrorOf(vtkHeightFieldShadowHeight* map)
{
  vtkNew<ErrorCatcher> catcher;
  catcher->Watch(map);
  map->SetInputData(Ridge());
  map->Update();
  EXPECT_EQ(map->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(catcher->Count, 1);
  return catcher->Text;
}

TEST(HeightFieldShadowHeight, RefusesInOneLine)
{
  vtkNew<vtkHeightFieldShadowHeight> map;
  map->SetSunElevation(91.0);
  EXPECT_NE(ErrorOf(map).find("91"), std::string::npos);
  map->SetSunElevation(45.0);
  map->SetSunAngularRadius(90.0);
  EXPECT_NE(ErrorOf(map).find("90"), std::string::npos);
  map->SetSunAngularRadius(0.2);
  map->SetMethodToPyramid();
  EXPECT_NE(ErrorOf(map).find("the pyramid has no shadow heights"), std::string::npos);
  map->SetMethodToExact();
  map->SetSurfaceToBilinear();
  EXPECT_NE(ErrorOf(map).find("the triangles"), std::string::npos);
}

} // namespace
} // namespace testing
} // namespace skyline
