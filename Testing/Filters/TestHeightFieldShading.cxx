// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldShading.h"

#include "Color/ColorMaps.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkShortArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

constexpr double Pi = 3.14159265358979323846;

// Radiance is a float: a dozen operations in double precision and one product in floats.
constexpr double RadianceTolerance = 2e-6;

using Height = std::function<double(double x, double y)>;

// A height field of doubles; x and y are metres from the south-west post.
vtkSmartPointer<vtkImageData> Field(
  int columns, int rows, double dx, double dy, const Height& height)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  image->SetSpacing(dx, dy, 1.0);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Elevation");
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      heights->InsertNextValue(height(column * dx, row * dy));
    }
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

void AddConstant(vtkImageData* image, const char* name, float value)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  array->FillComponent(0, value);
  image->GetPointData()->AddArray(array);
}

vtkDataArray* Radiance(vtkHeightFieldShading* shading)
{
  return shading->GetOutput()->GetPointData()->GetArray("Radiance");
}

vtkDataArray* Picture(vtkHeightFieldShading* shading)
{
  return shading->GetOutput()->GetPointData()->GetArray("Picture");
}

class Shading : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Filter->SetSunIrradiance(3.0, 2.0, 1.0);
    this->Filter->SetSkyRadiance(0.1, 0.2, 0.3);
    this->Filter->SetColorMap("gray");
    this->Filter->SetAutoExposure(false);
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this, &Shading::Remember);
  }

  void Remember(vtkObject*, unsigned long, void* text)
  {
    this->Error = static_cast<const char*>(text);
  }

  vtkNew<vtkHeightFieldShading> Filter;
  std::string Error;
};

// A plane z = a x + b y: normal, cosine of the sun and sky share have closed forms.
TEST_F(Shading, PlaneHasTheClosedFormRadiance)
{
  const double a = 0.3;
  const double b = -0.2;
  const auto plane = Field(5, 7, 10.0, 25.0, [&](double x, double y) { return a * x + b * y; });
  this->Filter->SetInputData(plane);
  this->Filter->SetSunAzimuth(120.0);
  this->Filter->SetSunElevation(30.0);
  this->Filter->SetColorRange(-1000.0, 1000.0);
  this->Filter->Update();
  const double up = 1.0 / std::sqrt(1.0 + a * a + b * b);
  const double azimuth = 120.0 * Pi / 180.0;
  const double elevation = 30.0 * Pi / 180.0;
  const double facing = up *
    (std::sin(elevation) - a * std::sin(azimuth) * std::cos(elevation) -
      b * std::cos(azimuth) * std::cos(elevation));
  const double sun[3] = { 3.0, 2.0, 1.0 };
  const double sky[3] = { 0.1, 0.2, 0.3 };
  const skyline::ColorMap& gray = *skyline::FindColorMap("gray");
  for (vtkIdType post = 0; post < 35; ++post)
  {
    const double height = plane->GetPointData()->GetScalars()->GetComponent(post, 0);
    const skyline::Rgb albedo =
      skyline::ColorAt(gray, skyline::PlaceOnMap(gray, height, -1000.0, 1000.0));
    for (int c = 0; c < 3; ++c)
    {
      const double expected = albedo[c] * (sun[c] * facing / Pi + sky[c] * 0.5 * (1.0 + up));
      EXPECT_NEAR(Radiance(this->Filter)->GetComponent(post, c), expected, RadianceTolerance);
    }
  }
}

TEST_F(Shading, VisibilitiesScaleTheirLights)
{
  const auto flat = Field(3, 3, 1.0, 1.0, [](double, double) { return 5.0; });
  AddConstant(flat, "SunVisibility", 0.25f);
  AddConstant(flat, "SkyViewFactor", 0.5f);
  this->Filter->SetInputData(flat);
  this->Filter->SetSunElevation(90.0);
  this->Filter->Update();
  const skyline::Rgb albedo = skyline::ColorAt(*skyline::FindColorMap("gray"), 0.5);
  EXPECT_NEAR(Radiance(this->Filter)->GetComponent(4, 0), albedo[0] * (0.25 * 3.0 / Pi + 0.5 * 0.1),
    RadianceTolerance);
  // The sky can be taken from another array.
  AddConstant(flat, "Overcast", 1.0f);
  this->Filter->SetSkyArrayName("Overcast");
  this->Filter->Update();
  EXPECT_NEAR(Radiance(this->Filter)->GetComponent(4, 2), albedo[2] * (0.25 * 1.0 / Pi + 1.0 * 0.3),
    RadianceTolerance);
}

// Of arrays with several components the first counts, whatever the type of the numbers.
TEST_F(Shading, VisibilitiesMayBeOfAnyType)
{
  const auto flat = Field(3, 3, 1.0, 1.0, [](double, double) { return 5.0; });
  vtkNew<vtkShortArray> visibility;
  visibility->SetName("SunVisibility");
  visibility->SetNumberOfTuples(9);
  visibility->FillComponent(0, 1.0);
  vtkNew<vtkDoubleArray> sky;
  sky->SetName("SkyViewFactor");
  sky->SetNumberOfComponents(3);
  sky->SetNumberOfTuples(9);
  for (int c = 0; c < 3; ++c)
  {
    sky->FillComponent(c, 0.5 + c);
  }
  flat->GetPointData()->AddArray(visibility);
  flat->GetPointData()->AddArray(sky);
  this->Filter->SetInputData(flat);
  this->Filter->SetSunElevation(90.0);
  this->Filter->Update();
  const skyline::Rgb albedo = skyline::ColorAt(*skyline::FindColorMap("gray"), 0.5);
  for (vtkIdType post = 0; post < 9; ++post)
  {
    EXPECT_NEAR(Radiance(this->Filter)->GetComponent(post, 0), albedo[0] * (3.0 / Pi + 0.5 * 0.1),
      RadianceTolerance);
  }
}

TEST_F(Shading, SunBehindTheSlopeGivesNoLight)
{
  this->Filter->SetInputData(Field(3, 3, 1.0, 1.0, [](double x, double) { return 2.0 * x; }));
  this->Filter->SetSunAzimuth(90.0); // the slope rises towards the sun
  this->Filter->SetSunElevation(30.0);
  this->Filter->SetSkyRadiance(0.0, 0.0, 0.0);
  this->Filter->Update();
  EXPECT_EQ(Radiance(this->Filter)->GetComponent(4, 0), 0.0);
  EXPECT_EQ(Picture(this->Filter)->GetComponent(4, 0), 0.0);
  EXPECT_EQ(Picture(this->Filter)->GetComponent(4, 3), 255.0);
}

// A plane has the same slope in one-sided and central differences, so a hole must not change its
// neighbours.
TEST_F(Shading, MissingPostsAreTransparentAndTheirNeighboursKeepTheirSlope)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto plane = Field(6, 5, 1.0, 1.0, [&](double x, double y) { return 0.5 * x + 0.25 * y; });
  this->Filter->SetColorMap("gray");
  this->Filter->SetColorRange(0.0, 1e9); // so wide that all posts have one colour
  this->Filter->SetInputData(plane);
  this->Filter->Update();
  const double expected = Radiance(this->Filter)->GetComponent(0, 0);
  vtkDataArray* heights = plane->GetPointData()->GetScalars();
  heights->SetComponent(14, 0, nan);
  heights->SetComponent(15, 0, infinity);
  plane->Modified();
  heights->Modified();
  this->Filter->Update();
  for (vtkIdType post = 0; post < 30; ++post)
  {
    const bool missing = post == 14 || post == 15;
    const double radiance = Radiance(this->Filter)->GetComponent(post, 0);
    EXPECT_EQ(Picture(this->Filter)->GetComponent(post, 3), missing ? 0.0 : 255.0);
    if (missing)
    {
      EXPECT_TRUE(std::isnan(radiance));
      EXPECT_EQ(Picture(this->Filter)->GetComponent(post, 0), 0.0);
    }
    else
    {
      EXPECT_NEAR(radiance, expected, RadianceTolerance);
    }
  }
}

// If all posts are missing, the picture is empty, but there is one.
TEST_F(Shading, AllMissingIsAnEmptyPicture)
{
  this->Filter->SetAutoExposure(true);
  this->Filter->SetInputData(
    Field(3, 3, 1.0, 1.0, [](double, double) { return std::numeric_limits<double>::quiet_NaN(); }));
  this->Filter->Update();
  EXPECT_EQ(this->Error, "");
  EXPECT_EQ(Picture(this->Filter)->GetRange(3)[1], 0.0);
  EXPECT_EQ(this->Filter->GetUsedExposure(), 0.0);
}

TEST_F(Shading, NothingBurnsOutAtAnyExposure)
{
  const auto hills = Field(40, 40, 30.0, 30.0,
    [](double x, double y) { return 300.0 * std::sin(x / 150.0) * std::cos(y / 170.0); });
  this->Filter->SetInputData(hills);
  this->Filter->SetColorMap("hypsometric");
  for (bool automatic : { true, false })
  {
    for (double exposure : { -4.0, 0.0, 4.0, 20.0, 100.0 })
    {
      this->Filter->SetAutoExposure(automatic);
      this->Filter->SetExposure(exposure);
      this->Filter->Update();
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_LT(Picture(this->Filter)->GetRange(c)[1], 255.0);
      }
    }
  }
}

// The automatic exposure makes the same picture for all strengths of the lights.
TEST_F(Shading, AutoExposureUndoesTheStrengthOfTheLights)
{
  const auto hills = Field(40, 40, 30.0, 30.0,
    [](double x, double y) { return 300.0 * std::sin(x / 150.0) * std::cos(y / 170.0); });
  this->Filter->SetInputData(hills);
  this->Filter->SetAutoExposure(true);
  this->Filter->Update();
  const double used = this->Filter->GetUsedExposure();
  vtkNew<vtkImageData> first;
  first->DeepCopy(this->Filter->GetOutput());
  this->Filter->SetSunIrradiance(3000.0, 2000.0, 1000.0);
  this->Filter->SetSkyRadiance(100.0, 200.0, 300.0);
  this->Filter->Update();
  EXPECT_NEAR(this->Filter->GetUsedExposure(), used - std::log2(1000.0), 1e-4);
  for (vtkIdType post = 0; post < 1600; ++post)
  {
    // A rounding error of the light can change a code by one.
    EXPECT_NEAR(Picture(this->Filter)->GetComponent(post, 1),
      first->GetPointData()->GetArray("Picture")->GetComponent(post, 1), 1.0);
  }
}

TEST_F(Shading, IntegerHeightsGiveTheSamePicture)
{
  const auto doubles =
    Field(9, 8, 10.0, 10.0, [](double x, double y) { return std::floor(x * y / 50.0); });
  this->Filter->SetInputData(doubles);
  this->Filter->Update();
  vtkNew<vtkImageData> first;
  first->DeepCopy(this->Filter->GetOutput());
  vtkNew<vtkImageData> integers;
  integers->CopyStructure(doubles);
  vtkNew<vtkShortArray> heights;
  heights->DeepCopy(doubles->GetPointData()->GetScalars());
  integers->GetPointData()->SetScalars(heights);
  this->Filter->SetInputData(integers);
  this->Filter->Update();
  for (vtkIdType post = 0; post < 72; ++post)
  {
    EXPECT_EQ(Radiance(this->Filter)->GetComponent(post, 0),
      first->GetPointData()->GetArray("Radiance")->GetComponent(post, 0));
  }
}

TEST_F(Shading, ThreadCountChangesNothing)
{
  const auto hills = Field(67, 301, 30.0, 30.0,
    [](double x, double y) { return 300.0 * std::sin(x / 150.0) * std::cos(y / 170.0); });
  this->Filter->SetInputData(hills);
  this->Filter->SetAutoExposure(true);
  std::vector<std::vector<unsigned char>> pictures;
  for (int threads : { 1, 2, 3, 8 })
  {
    vtkSMPTools::Initialize(threads);
    this->Filter->Modified();
    this->Filter->Update();
    const auto* bytes = static_cast<unsigned char*>(Picture(this->Filter)->GetVoidPointer(0));
    pictures.emplace_back(bytes, bytes + 4 * 67 * 301);
    EXPECT_EQ(pictures.back(), pictures.front()) << threads;
  }
  vtkSMPTools::Initialize(0);
}

TEST_F(Shading, LookupTableReplacesTheNamedMap)
{
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 1.0, 0.0, 0.0);
  table->SetTableValue(1, 0.0, 0.0, 1.0);
  this->Filter->SetLookupTable(table);
  this->Filter->SetInputData(Field(3, 2, 1.0, 1.0, [](double x, double) { return 1e-6 * x; }));
  this->Filter->Update();
  EXPECT_GT(Picture(this->Filter)->GetComponent(0, 0), 0.0);
  EXPECT_EQ(Picture(this->Filter)->GetComponent(0, 2), 0.0);
  EXPECT_EQ(Picture(this->Filter)->GetComponent(2, 0), 0.0);
  EXPECT_GT(Picture(this->Filter)->GetComponent(2, 2), 0.0);
}

TEST_F(Shading, OutputKeepsTheInputAndShowsThePicture)
{
  this->Filter->SetInputData(Field(3, 2, 1.0, 1.0, [](double x, double) { return x; }));
  this->Filter->Update();
  vtkImageData* out = this->Filter->GetOutput();
  EXPECT_NE(out->GetPointData()->GetArray("Elevation"), nullptr);
  EXPECT_STREQ(out->GetPointData()->GetScalars()->GetName(), "Picture");
  EXPECT_EQ(out->GetPointData()->GetScalars()->GetNumberOfComponents(), 4);
  EXPECT_EQ(Radiance(this->Filter)->GetNumberOfComponents(), 3);
}

TEST_F(Shading, BadInputIsNamed)
{
  this->Filter->SetInputData(Field(3, 1, 1.0, 1.0, [](double, double) { return 0.0; }));
  this->Filter->Update();
  EXPECT_NE(this->Error.find("no surface"), std::string::npos) << this->Error;
  this->Filter->SetInputData(Field(3, 3, 1.0, 1.0, [](double, double) { return 0.0; }));
  this->Filter->SetColorMap("rainbow");
  this->Filter->Update();
  EXPECT_NE(this->Error.find("no colour map named rainbow"), std::string::npos) << this->Error;
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(3, 3, 1);
  this->Filter->SetInputData(bare);
  this->Filter->Update();
  EXPECT_NE(this->Error.find("no heights"), std::string::npos) << this->Error;
}

} // namespace
