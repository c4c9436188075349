// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"
#include "Shared/Constants.h"

#include "vtkHeightFieldReader.h"
#include "vtkHeightFieldShadowHeight.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkSkylineSunLight.h"

#include <gtest/gtest.h>

#include <cmath>

namespace skyline
{
namespace testing
{
namespace
{

// Compares the posts that see more than half of the disc with the oracle's sun without size.
double Agreement(
  const oracle::OracleField& field, vtkImageData* image, double azimuth, double elevation)
{
  vtkNew<vtkHeightFieldSunShadow> filter;
  filter->SetInputData(image);
  filter->FlatOn();
  filter->SetSunAzimuth(azimuth);
  filter->SetSunElevation(elevation);
  filter->Update();
  vtkFloatArray* visibility = ArrayOf(filter, "SunVisibility");
  const std::vector<double> slopes = oracle::HorizonSlopes(field, azimuth);
  std::size_t equal = 0;
  for (std::size_t post = 0; post < slopes.size(); ++post)
  {
    const bool lit = oracle::ElevationDegrees(slopes[post]) < elevation;
    equal += lit == (visibility->GetValue(static_cast<vtkIdType>(post)) > 0.5f) ? 1 : 0;
  }
  return static_cast<double>(equal) / static_cast<double>(slopes.size());
}

// 99.5 % of the posts must agree, with the sun at 15 degrees.
constexpr double AgreementBound = 0.995;

TEST(SunShadow, MaskOfStHelens)
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(SKYLINE_TEST_DATA "/exact/sthelens_crop160_dem.tif");
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  oracle::OracleField field(160, 160, 30.0, 30.0);
  for (vtkIdType post = 0; post < image->GetNumberOfPoints(); ++post)
  {
    field.Heights[static_cast<std::size_t>(post)] =
      image->GetPointData()->GetScalars()->GetComponent(post, 0);
  }
  for (const double azimuth : { 45.0, 135.0, 222.0, 300.0 })
  {
    EXPECT_GE(Agreement(field, image, azimuth, 15.0), AgreementBound) << azimuth;
  }
}

TEST(SunShadow, MaskOfAHousingEstate)
{
  const oracle::OracleField field = shapes::RandomBoxes(200, 200, 0.5, 60, 20, 12.0, 5);
  const auto image = ImageOf<vtkFloatArray>(field);
  for (const double azimuth : { 90.0, 160.0, 250.0 })
  {
    EXPECT_GE(Agreement(field, image, azimuth, 15.0), AgreementBound) << azimuth;
  }
}

// A wall with the height H at the distance D cuts the disc in half where H / D = tan(elevation).
// Behind a long wall with the sun straight across, the half-lit line lies at H / tan(elevation)
// from the wall, and the penumbra is as wide as the disc.
TEST(SunShadow, PenumbraOfAWall)
{
  const double height = 100.0;
  oracle::OracleField field = shapes::Plane(801, 41, 1.0, 0.0, 0.0);
  for (std::ptrdiff_t row = 0; row < field.Rows; ++row)
  {
    field.At(800, row) = height;
  }
  vtkNew<vtkHeightFieldSunShadow> filter;
  filter->SetInputData(ImageOf<vtkDoubleArray>(field));
  filter->SetSunAzimuth(90.0);
  filter->SetSunElevation(20.0);
  filter->SetSunAngularRadius(0.5);
  filter->Update();
  vtkFloatArray* visibility = ArrayOf(filter, "SunVisibility");
  for (std::ptrdiff_t column = 400; column < 700; ++column)
  {
    const double distance = static_cast<double>(800 - column);
    // A level edge t radii above the centre cuts the disc: the visible part is (acos t - t sqrt(1 -
    // t^2)) / pi. The top of the wall is level, but appears lower towards the sides of the disc;
    // over half a degree this is 1e-5 of the slope.
    const double t = (std::atan(height / distance) * DegreesPerRadian - 20.0) / 0.5;
    const double lit = t >= 1.0 ? 0.0
      : t <= -1.0               ? 1.0
                                : (std::acos(t) - t * std::sqrt(1.0 - t * t)) / Pi;
    EXPECT_NEAR(visibility->GetValue(20 * 801 + column), lit, 0.006) << distance;
  }
}

// The sun at the place of the included DEM: at noon all posts are lit, at midnight all are dark.
TEST(SunShadow, TimeOfDay)
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(SKYLINE_TEST_DATA "/exact/sthelens_crop160_dem.tif");
  vtkNew<vtkHeightFieldSunShadow> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->UseTimeOn();
  const auto mean = [&](const char* time)
  {
    filter->SetTime(time);
    filter->Update();
    vtkFloatArray* visibility = ArrayOf(filter, "SunVisibility");
    double sum = 0.0;
    for (vtkIdType post = 0; post < visibility->GetNumberOfTuples(); ++post)
    {
      sum += visibility->GetValue(post);
    }
    return sum / static_cast<double>(visibility->GetNumberOfTuples());
  };
  EXPECT_GT(mean("2026-06-21T20:10Z"), 0.99); // solar noon at 122 degrees west
  EXPECT_EQ(mean("2026-06-21T08:10Z"), 0.0);  // midnight
  const double morning = mean("2026-06-21T13:00Z");
  EXPECT_GT(morning, 0.1);
  EXPECT_LT(morning, 0.9);

  // With a sun without size, each post is either lit or dark.
  filter->TrueRadiusOff();
  filter->SetSunAngularRadius(0.0);
  EXPECT_NEAR(mean("2026-06-21T13:00Z"), morning, 0.01);
  vtkFloatArray* visibility = ArrayOf(filter, "SunVisibility");
  for (vtkIdType post = 0; post < visibility->GetNumberOfTuples(); ++post)
  {
    const float lit = visibility->GetValue(post);
    ASSERT_TRUE(lit == 0.0f || lit == 1.0f) << post;
  }
}

// The public header states this number too.
TEST(SunShadow, DefaultRadiusIsTheMeanSuns)
{
  EXPECT_EQ(vtkNew<vtkHeightFieldSunShadow>()->GetSunAngularRadius(), MeanSunRadius);
  EXPECT_EQ(vtkNew<vtkHeightFieldShadowHeight>()->GetSunAngularRadius(), MeanSunRadius);
  EXPECT_EQ(vtkNew<vtkSkylineSunLight>()->GetAngularRadius(), MeanSunRadius);
}

} // namespace
} // namespace testing
} // namespace skyline
