// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldSkyLight.h"

#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkHeightFieldSkyView.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace
{

// The error of the tables of ZonalSky.h, and of sums of floats over 72 azimuths.
constexpr double LightTolerance = 2e-5;

vtkSmartPointer<vtkImageData> Field(
  int columns, int rows, const std::function<double(double x, double y)>& height)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  image->SetSpacing(10.0, 10.0, 1.0);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Elevation");
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      heights->InsertNextValue(height(10.0 * column, 10.0 * row));
    }
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

double Hills(double x, double y)
{
  return 60.0 * std::sin(x / 70.0) * std::cos(y / 50.0) + 20.0 * std::sin((x + y) / 30.0);
}

vtkDataArray* Light(vtkHeightFieldSkyLight* filter)
{
  return filter->GetOutput()->GetPointData()->GetArray("SkyLight");
}

TEST(SkyLight, LevelGroundGetsAll)
{
  for (int type : { 1, 3, 5, 16 })
  {
    vtkNew<vtkHeightFieldSkyLight> filter;
    filter->SetInputData(Field(9, 8, [](double, double) { return 7.0; }));
    filter->SetCieType(type);
    filter->Update();
    for (vtkIdType post = 0; post < 72; ++post)
    {
      EXPECT_NEAR(Light(filter)->GetComponent(post, 0), 1.0, LightTolerance);
    }
  }
}

// Another method for the same number.
TEST(SkyLight, UniformSkyIsTheSkyViewFactor)
{
  const auto hills = Field(40, 30, Hills);
  hills->GetPointData()->GetScalars()->SetComponent(
    605, 0, std::numeric_limits<double>::quiet_NaN());
  vtkNew<vtkHeightFieldSkyLight> filter;
  filter->SetInputData(hills);
  filter->SetCieType(5);
  filter->Update();
  vtkNew<vtkHeightFieldSkyView> view;
  view->SetInputData(hills);
  view->Update();
  vtkDataArray* factor = view->GetOutput()->GetPointData()->GetArray("SkyViewFactor");
  for (vtkIdType post = 0; post < factor->GetNumberOfTuples(); ++post)
  {
    const double light = Light(filter)->GetComponent(post, 0);
    if (post == 605)
    {
      EXPECT_TRUE(std::isnan(light));
      continue;
    }
    EXPECT_NEAR(light, factor->GetComponent(post, 0), LightTolerance) << post;
  }
}

// Terrain hides the low part of the sky first, which is the dark part of an overcast sky.
TEST(SkyLight, OvercastSkyLosesLessBehindHorizons)
{
  const auto trench =
    Field(41, 41, [](double x, double) { return std::abs(x - 200.0) < 25.0 ? -60.0 : 0.0; });
  double before = 0.0;
  for (int type : { 5, 3, 1 }) // each darker towards the horizon than the one before
  {
    vtkNew<vtkHeightFieldSkyLight> filter;
    filter->SetInputData(trench);
    filter->SetCieType(type);
    filter->Update();
    const double middle = Light(filter)->GetComponent(20 * 41 + 20, 0);
    EXPECT_GT(middle, before + 0.005);
    EXPECT_LT(middle, 1.0);
    before = middle;
  }
}

struct Listener
{
  void Hear(vtkObject*, unsigned long, void* text) { this->Text = static_cast<const char*>(text); }
  std::string Text;
};

TEST(SkyLight, SkiesThatFollowTheSunAreRefused)
{
  Listener listener;
  vtkNew<vtkHeightFieldSkyLight> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, &listener, &Listener::Hear);
  filter->SetInputData(Field(9, 8, Hills));
  filter->SetCieType(12);
  filter->Update();
  EXPECT_NE(listener.Text.find("CIE sky 12"), std::string::npos) << listener.Text;
}

} // namespace
