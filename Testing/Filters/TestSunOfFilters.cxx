// SPDX-License-Identifier: BSD-3-Clause
// One vtkSkylineSunLight for several filters.
#include "FilterTesting.h"

#include "vtkFieldData.h"
#include "vtkHeightFieldReader.h"
#include "vtkHeightFieldShading.h"
#include "vtkHeightFieldShadowHeight.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineLampLight.h"
#include "vtkSkylineSunLight.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace skyline
{
namespace testing
{
namespace
{

constexpr const char* Morning = "2026-06-21T14:00Z";

vtkSmartPointer<vtkImageData> StHelens()
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(SKYLINE_TEST_DATA "/exact/sthelens_crop160_dem.tif");
  reader->Update();
  return reader->GetOutput();
}

void ExpectEqual(vtkDataArray* found, vtkDataArray* expected)
{
  ASSERT_EQ(found->GetNumberOfValues(), expected->GetNumberOfValues());
  for (vtkIdType value = 0; value < found->GetNumberOfValues(); ++value)
  {
    ASSERT_EQ(found->GetVariantValue(value).ToDouble(), expected->GetVariantValue(value).ToDouble())
      << value;
  }
}

std::string Printed(vtkObject* object)
{
  std::ostringstream text;
  object->Print(text);
  return text.str();
}

TEST(SunOfFilters, IsSharedAndFollowed)
{
  const auto terrain = StHelens();
  vtkNew<vtkSkylineSunLight> sun;
  vtkNew<vtkHeightFieldSunShadow> shadow;
  shadow->SetInputData(terrain);
  shadow->SetSun(sun);
  vtkNew<vtkHeightFieldShadowHeight> heights;
  heights->SetInputData(terrain);
  heights->SetSun(sun);
  vtkNew<vtkHeightFieldShading> shading;
  shading->SetInputConnection(shadow->GetOutputPort());
  shading->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
  shading->SetSun(sun);

  sun->SetAzimuth(100.0);
  sun->SetElevation(12.0);
  sun->SetIrradiance(3.0, 2.0, 1.0);
  for (vtkAlgorithm* filter : std::initializer_list<vtkAlgorithm*>{ shadow, heights, shading })
  {
    const vtkMTimeType before = filter->GetMTime();
    sun->SetAzimuth(sun->GetAzimuth() + 1.0);
    EXPECT_GT(filter->GetMTime(), before);
  }
  shading->Update();
  heights->Update();

  // The same by filters with suns of their own.
  vtkNew<vtkHeightFieldSunShadow> alone;
  alone->SetInputData(terrain);
  alone->SetSunAzimuth(103.0);
  alone->SetSunElevation(12.0);
  vtkNew<vtkHeightFieldShading> picture;
  picture->SetInputConnection(alone->GetOutputPort());
  picture->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
  picture->SetSunAzimuth(103.0);
  picture->SetSunElevation(12.0);
  picture->SetSunIrradiance(3.0, 2.0, 1.0);
  picture->Update();
  ExpectEqual(shading->GetOutput()->GetPointData()->GetArray("SunVisibility"),
    picture->GetOutput()->GetPointData()->GetArray("SunVisibility"));
  ExpectEqual(shading->GetOutput()->GetPointData()->GetArray("Radiance"),
    picture->GetOutput()->GetPointData()->GetArray("Radiance"));
  EXPECT_EQ(heights->GetOutput()->GetFieldData()->GetArray("ShadowSun")->GetComponent(0, 0), 103.0);

  sun->SwitchOff();
  picture->SetSunIrradiance(0.0, 0.0, 0.0);
  shading->Update();
  picture->Update();
  ExpectEqual(shading->GetOutput()->GetPointData()->GetArray("Radiance"),
    picture->GetOutput()->GetPointData()->GetArray("Radiance"));
}

TEST(SunOfFilters, NullIsANewOne)
{
  vtkNew<vtkHeightFieldSunShadow> shadow;
  shadow->SetSunAzimuth(10.0);
  shadow->SetSun(nullptr);
  EXPECT_EQ(shadow->GetSunAzimuth(), 315.0);
  vtkNew<vtkHeightFieldShading> shading;
  const double red = shading->GetSunIrradiance()[0];
  shading->SetSunIrradiance(0.0, 0.0, 0.0);
  shading->SetSun(nullptr);
  EXPECT_EQ(shading->GetSunIrradiance()[0], red);
}

TEST(SunOfFilters, IsPrinted)
{
  vtkNew<vtkHeightFieldSunShadow> shadow;
  shadow->SetTime(Morning);
  EXPECT_NE(Printed(shadow).find(Morning), std::string::npos);
  vtkNew<vtkHeightFieldShading> shading;
  shading->SetTime(Morning);
  EXPECT_NE(Printed(shading).find(Morning), std::string::npos);
}

// Shadow heights by time are those of the sun over the middle, which FindDirection tells.
TEST(SunOfFilters, ShadowHeightsKnowATime)
{
  const auto terrain = StHelens();
  vtkNew<vtkHeightFieldShadowHeight> byTime;
  byTime->SetInputData(terrain);
  byTime->UseTimeOn();
  byTime->SetTime("2026-06-21T12:00Z");
  byTime->SetHoursLater(2.0);
  byTime->SoftOn();
  byTime->Update();
  double direction[3];
  ASSERT_TRUE(byTime->GetSun()->FindDirection(terrain, direction));
  vtkNew<vtkHeightFieldShadowHeight> byDirection;
  byDirection->SetInputData(terrain);
  byDirection->SetSunAzimuth(direction[0]);
  byDirection->SetSunElevation(direction[1]);
  byDirection->SetSunAngularRadius(direction[2]);
  byDirection->SoftOn();
  byDirection->Update();
  ASSERT_GT(direction[1], 5.0);
  for (const char* name : { "ShadowHeight", "ShadowHeightUpper", "ShadowHeightLower" })
  {
    ExpectEqual(byTime->GetOutput()->GetPointData()->GetArray(name),
      byDirection->GetOutput()->GetPointData()->GetArray(name));
  }
  vtkDataArray* used = byTime->GetOutput()->GetFieldData()->GetArray("ShadowSun");
  for (int part = 0; part < 3; ++part)
  {
    EXPECT_EQ(used->GetComponent(0, part), direction[part]);
  }
}

TEST(SunOfFilters, LaterIsAnotherTime)
{
  const auto terrain = StHelens();
  vtkNew<vtkHeightFieldSunShadow> later;
  later->SetInputData(terrain);
  later->UseTimeOn();
  later->SetTime("2026-06-21T12:00Z");
  later->SetHoursLater(2.0);
  later->Update();
  vtkNew<vtkHeightFieldSunShadow> then;
  then->SetInputData(terrain);
  then->UseTimeOn();
  then->SetTime(Morning);
  then->Update();
  ExpectEqual(later->GetOutput()->GetPointData()->GetArray("SunVisibility"),
    then->GetOutput()->GetPointData()->GetArray("SunVisibility"));
}

std::string ErrorOf(vtkAlgorithm* filter)
{
  vtkNew<ErrorCatcher> catcher;
  catcher->Watch(filter);
  filter->Update();
  EXPECT_EQ(catcher->Count, 1);
  return catcher->Text;
}

TEST(SunOfFilters, WhatIsWrongIsNamed)
{
  const auto terrain = StHelens();
  vtkNew<vtkSkylineSunLight> sun;
  sun->UseTimeOn();
  vtkNew<vtkHeightFieldSunShadow> shadow;
  vtkNew<vtkHeightFieldShadowHeight> heights;
  vtkNew<vtkHeightFieldShading> shading;
  shadow->SetInputData(terrain);
  heights->SetInputData(terrain);
  shading->SetInputData(terrain);
  shadow->SetSun(sun);
  heights->SetSun(sun);
  shading->SetSun(sun);
  const auto expect = [&](const std::string& words)
  {
    for (vtkAlgorithm* filter : std::initializer_list<vtkAlgorithm*>{ shadow, heights, shading })
    {
      const std::string error = ErrorOf(filter);
      EXPECT_NE(error.find(words), std::string::npos) << error;
    }
  };
  expect("the sun has no time; set its Time, such as 2026-06-21T14:00Z");
  sun->SetTime("21 June");
  expect("21 June");
  sun->SetTime(Morning);
  sun->SetHoursLater(1e9);
  expect("hours; give less than 1e7");
  sun->UseTimeOff();
  sun->SetElevation(91.0);
  expect("sun elevation 91");
}

TEST(SunOfFilters, TimesAreCheckedBeforeUse)
{
  EXPECT_EQ(vtkSkylineSunLight::FindTimeError(Morning), "");
  EXPECT_NE(vtkSkylineSunLight::FindTimeError("21 June").find("is not a time"), std::string::npos);
  EXPECT_NE(vtkSkylineSunLight::FindTimeError("2101-01-01").find("2100"), std::string::npos);
  EXPECT_TRUE(vtkSkylineSunLight::NamesZone(Morning));
  EXPECT_FALSE(vtkSkylineSunLight::NamesZone("2026-06-21T14:00"));
}

TEST(SkyOfEnvironment, IsReadFromText)
{
  vtkNew<vtkSkylineEnvironmentLight> light;
  EXPECT_TRUE(light->SetSky("perez:700,120"));
  EXPECT_EQ(light->GetSource(), vtkSkylineEnvironmentLight::PEREZ);
  EXPECT_EQ(light->GetDirectIrradiance(), 700.0);
  EXPECT_EQ(light->GetDiffuseIrradiance(), 120.0);
  EXPECT_FALSE(light->IsSameAllAround());
  EXPECT_TRUE(light->SetSky("cie:16"));
  EXPECT_EQ(light->GetCieType(), 16);
  EXPECT_TRUE(light->IsSameAllAround());
  EXPECT_FALSE(light->SetSky("map.hdr"));
  EXPECT_EQ(light->GetSource(), vtkSkylineEnvironmentLight::CIE);
  EXPECT_TRUE(light->SetSky("uniform"));
  EXPECT_TRUE(light->IsSameAllAround());
  vtkNew<ErrorCatcher> catcher;
  light->AddObserver(vtkCommand::ErrorEvent, catcher);
  EXPECT_FALSE(light->SetSky("cie:17"));
  EXPECT_EQ(catcher->Count, 1);
  EXPECT_NE(catcher->Text.find("cie:1 to cie:16"), std::string::npos) << catcher->Text;
}

// The south-west post of a raster is the origin of its image.
TEST(LampOnAMap, StandsWhereTheMapSays)
{
  const auto terrain = StHelens();
  vtkDataArray* transform = terrain->GetFieldData()->GetArray("GeoTransform");
  const double rows = terrain->GetDimensions()[1];
  vtkNew<vtkSkylineLampLight> lamp;
  lamp->SetMapPosition(terrain, transform->GetComponent(0, 0) + 2.5 * transform->GetComponent(0, 1),
    transform->GetComponent(0, 3) + (rows - 0.5) * transform->GetComponent(0, 5), 7.0);
  EXPECT_NEAR(
    lamp->GetPosition()[0], terrain->GetOrigin()[0] + 2.0 * terrain->GetSpacing()[0], 1e-6);
  EXPECT_NEAR(lamp->GetPosition()[1], terrain->GetOrigin()[1], 1e-6);
  EXPECT_EQ(lamp->GetPosition()[2], 7.0);
  vtkNew<vtkImageData> plain;
  lamp->SetMapPosition(plain, 1.0, 2.0, 3.0);
  EXPECT_EQ(lamp->GetPosition()[0], 1.0);
  lamp->SetMapPosition(nullptr, 4.0, 2.0, 3.0);
  EXPECT_EQ(lamp->GetPosition()[0], 4.0);
}

} // namespace
} // namespace testing
} // namespace skyline
