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

// Posts that are lit by more than half of the disc against the oracle's point sun.
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

// The bound: 99.5 % of the posts, at 15 degrees of sun.
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

// A wall of height H stands D away: the disc's centre is cut in half where H / D = tan(elevation).
// The half-lit line of a long wall, sun straight across it, is at H / tan(elevation) from it, and the
// penumbra is as wide as the disc.
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
    // A level edge cuts the disc t radii above its centre: lit (acos t - t sqrt(1 - t^2)) / pi. The
    // wall's top is level but seen under a lower angle to the sides of the disc; over half a degree
    // that is 1e-5 of the slope.
    const double t = (std::atan(height / distance) * DegreesPerRadian - 20.0) / 0.5;
    const double lit = t >= 1.0 ? 0.0
      : t <= -1.0               ? 1.0
                                : (std::acos(t) - t * std::sqrt(1.0 - t * t)) / Pi;
    EXPECT_NEAR(visibility->GetValue(20 * 801 + column), lit, 0.006) << distance;
  }
}

// The sun of the bundled DEM's place: high noon lights every post that midnight darkens.
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
  EXPECT_EQ(mean("2026-06-21T08:10Z"), 0.0);  // the other side of the day
  const double morning = mean("2026-06-21T13:00Z");
  EXPECT_GT(morning, 0.1);
  EXPECT_LT(morning, 0.9);

  // A point in the place of the disc: every post is lit or dark.
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

// The headers write the number again, for those who read them.
TEST(SunShadow, DefaultRadiusIsTheMeanSuns)
{
  EXPECT_EQ(vtkNew<vtkHeightFieldSunShadow>()->GetSunAngularRadius(), MeanSunRadius);
  EXPECT_EQ(vtkNew<vtkHeightFieldShadowHeight>()->GetSunAngularRadius(), MeanSunRadius);
  EXPECT_EQ(vtkNew<vtkSkylineSunLight>()->GetAngularRadius(), MeanSunRadius);
}

} // namespace
} // namespace testing
} // namespace skyline
