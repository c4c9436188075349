// SPDX-License-Identifier: BSD-3-Clause
// All filters on all extreme fields, of doubles and of floats, with all methods. The result must be
// NaN at missing posts and only there, and other values must lie in their range.
#include "HorizonBounds.h"
#include "StabilityScenes.h"

#include "Testing/Filters/FilterTesting.h"

#include "vtkHeightFieldHorizon.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldShadowHeight.h"
#include "vtkHeightFieldSkyView.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkHeightFieldTransfer.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineKeyLight.h"
#include "vtkSkylineLampLight.h"
#include "vtkSkylineSunLight.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

namespace skyline
{
namespace testing
{
namespace
{

enum class Heights
{
  Float,
  Double
};

class StabilityOfFilters : public ::testing::TestWithParam<std::tuple<StabilityScene, Heights>>
{
protected:
  void SetUp() override
  {
    this->Field = std::get<0>(GetParam()).Make();
    const bool floats = std::get<1>(GetParam()) == Heights::Float;
    this->Field = floats ? AsFloats(this->Field) : this->Field;
    this->Field.CurvatureDrop = 0.0; // an image without a georeference is flat
    this->Image =
      floats ? ImageOf<vtkFloatArray>(this->Field) : ImageOf<vtkDoubleArray>(this->Field);
    // Coordinates like those of a UTM zone, in doubles as in a raster.
    this->Image->SetOrigin(5.0e5, 4.6e6, 0.0);
  }

  /// Runs the filter with each method up to `last`, and checks that the values of the arrays lie in
  /// [low, high].
  template <typename Filter>
  void RunAll(Filter* filter, const std::vector<const char*>& arrays, double low, double high,
    int last = vtkHeightFieldAlgorithm::PYRAMID)
  {
    filter->SetInputData(this->Image);
    for (int method = vtkHeightFieldAlgorithm::EXACT; method <= last; ++method)
    {
      filter->SetMethod(method);
      filter->Update();
      for (const char* name : arrays)
      {
        this->Check(filter, name, low, high, name + (" by method " + std::to_string(method)));
      }
    }
  }

  void Check(
    vtkAlgorithm* filter, const char* name, double low, double high, const std::string& what)
  {
    vtkFloatArray* values = ArrayOf(filter, name);
    ASSERT_NE(values, nullptr) << what;
    const int components = values->GetNumberOfComponents();
    for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
    {
      const double value = values->GetValue(i);
      const auto post = static_cast<std::size_t>(i / components);
      ASSERT_EQ(std::isnan(value), !std::isfinite(this->Field.Heights[post]))
        << what << " " << post;
      ASSERT_TRUE(std::isnan(value) || (value >= low && value <= high))
        << what << " is " << value << " at post " << post;
    }
  }

  oracle::OracleField Field;
  vtkSmartPointer<vtkImageData> Image;
};

constexpr double Sums = 1.0e-5; // of some floats up to 1

TEST_P(StabilityOfFilters, HorizonsAreThoseOfTheOracle)
{
  constexpr int azimuths = 16;
  std::vector<std::vector<double>> truth;
  for (int k = 0; k < azimuths; ++k)
  {
    truth.push_back(oracle::HorizonSlopes(this->Field, 360.0 * k / azimuths));
  }
  vtkNew<vtkHeightFieldHorizon> horizon;
  horizon->SetInputData(this->Image);
  horizon->SetNumberOfAzimuths(azimuths);
  for (const TestedMethod& tested : TestedMethods())
  {
    horizon->SetMethod(static_cast<int>(tested.Kind));
    const bool tolerant = tested.Kind == HorizonMethodKind::Exact && tested.Tolerance > 0.0;
    horizon->SetTolerance(tolerant ? tested.Tolerance * DegreesPerRadian : 0.0);
    horizon->Update();
    this->Check(horizon, "HorizonElevation", -90.0, 90.0, tested.Name);
    vtkFloatArray* found = ArrayOf(horizon, "HorizonElevation");
    for (vtkIdType i = 0; i < found->GetNumberOfValues(); ++i)
    {
      const double slope =
        truth[static_cast<std::size_t>(i % azimuths)][static_cast<std::size_t>(i / azimuths)];
      ASSERT_TRUE(std::isnan(slope) || Keeps(this->Field, tested, found->GetValue(i), slope))
        << tested.Name << ": " << found->GetValue(i) << " in place of "
        << oracle::ElevationDegrees(slope) << " degrees at value " << i;
    }
  }
}

TEST_P(StabilityOfFilters, SkyViews)
{
  vtkNew<vtkHeightFieldSkyView> sky;
  sky->SetNumberOfAzimuths(16);
  this->RunAll(sky.GetPointer(),
    { "SkyViewFactor", "SkyViewFactorHorizontal", "VisibleSkyFraction" }, 0.0, 1.0 + Sums);
  this->RunAll(sky.GetPointer(), { "PositiveOpenness" }, 0.0, 180.0 + 180.0 * Sums);
}

TEST_P(StabilityOfFilters, SunsOfAllElevations)
{
  vtkNew<vtkHeightFieldSunShadow> sun;
  sun->SetInputData(this->Image);
  std::vector<std::vector<float>> lit;
  for (const double radius : { 0.0, 0.26645, 20.0 })
  {
    sun->SetSunAngularRadius(radius);
    for (const double azimuth : { 0.0, 45.0, 359.9, 405.0 })
    {
      sun->SetSunAzimuth(azimuth);
      for (const double elevation : { -90.0, -1.0, 0.0, 0.1, 33.0, 89.9, 90.0 })
      {
        sun->SetSunElevation(elevation);
        this->RunAll(sun.GetPointer(), { "SunVisibility" }, 0.0,
          elevation + radius <= 0.0 ? 0.0 : 1.0, vtkHeightFieldAlgorithm::EXACT);
      }
    }
  }
  this->RunAll(sun.GetPointer(), { "SunVisibility" }, 0.0, 1.0);
}

TEST_P(StabilityOfFilters, LightsOfAllKinds)
{
  vtkNew<vtkHeightFieldIrradiance> light;
  light->SetNumberOfAzimuths(16);
  // Radiance 1 from all directions: at most pi, plus the error of the swaths, w^2 / 24 of it.
  vtkNew<vtkSkylineEnvironmentLight> white;
  light->AddLight(white);
  this->RunAll(light.GetPointer(), { "Irradiance" }, 0.0, Pi * 1.007);
  light->SetLightMethodToHarmonics();
  // A series oscillates: up to a tenth of the light can be added or subtracted.
  this->RunAll(light.GetPointer(), { "Irradiance" }, -0.1 * Pi, 1.1 * Pi);
  light->SetLightMethodToTable();
  light->RemoveAllLights();
  // Irradiance 1 on a plane that faces the sun. The disc of 60 degrees is a light of radiance 1.
  vtkNew<vtkSkylineSunLight> sun;
  sun->SetElevation(0.2);
  light->AddLight(sun);
  this->RunAll(light.GetPointer(), { "Irradiance" }, 0.0, 1.0 + Sums);
  light->RemoveAllLights();
  vtkNew<vtkSkylineKeyLight> key;
  key->SetElevation(80.0);
  key->SetAngularRadius(60.0);
  light->AddLight(key);
  this->RunAll(light.GetPointer(), { "Irradiance" }, 0.0, Pi * 1.007);
  light->RemoveAllLights();
  // In the middle of the field, half below the ground at this position or near it.
  double range[2];
  this->Image->GetPointData()->GetScalars()->GetFiniteRange(range);
  double bounds[6];
  this->Image->GetBounds(bounds);
  vtkNew<vtkSkylineLampLight> lamp;
  lamp->SetPosition(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), range[1]);
  lamp->SetRadius(0.1 * (bounds[1] - bounds[0]));
  light->AddLight(lamp);
  this->RunAll(
    light.GetPointer(), { "Irradiance" }, 0.0, Pi * 1.0001, vtkHeightFieldHorizon::EXACT);
}

TEST_P(StabilityOfFilters, HarmonicsOfSwaths)
{
  // No coefficient is greater than the square root of the energy of its function (Bessel's
  // inequality): the function is at most 1 on half of the sphere, or a cosine there.
  const double sphere = std::sqrt(2.0 * Pi) + 1e-4;
  const double cosine = std::sqrt(2.0 / 3.0 * Pi) + 1e-4;
  vtkNew<vtkHeightFieldVisibility> visibility;
  vtkNew<vtkHeightFieldTransfer> transfer;
  for (vtkHeightFieldVisibility* filter :
    { visibility.GetPointer(), static_cast<vtkHeightFieldVisibility*>(transfer.GetPointer()) })
  {
    const bool second = filter == transfer.GetPointer();
    filter->SetNumberOfAzimuths(6);
    for (const double width : { 1.0, 90.0, 360.0 })
    {
      filter->SetSwathAzimuth(359.8);
      filter->SetSwathWidth(width);
      const double energy = std::sqrt(width / 360.0) * (second ? std::sqrt(3.0) * cosine : sphere);
      const double bound = std::min(energy, second ? cosine : sphere);
      this->RunAll(filter, { second ? "TransferSH" : "VisibilitySH" }, -bound, bound);
    }
  }
}

TEST_P(StabilityOfFilters, ShadowHeights)
{
  double range[2];
  this->Image->GetPointData()->GetScalars()->GetFiniteRange(range);
  // The distance between floats near the greatest height.
  const double spacing = 2.4e-7 * std::max(std::abs(range[0]), std::abs(range[1]));
  vtkNew<vtkHeightFieldShadowHeight> shadow;
  for (const double elevation : { 0.01, 25.0, 90.0 })
  {
    shadow->SetSunElevation(elevation);
    this->RunAll(shadow.GetPointer(), { "ShadowHeight" }, range[0] - spacing, range[1] + spacing,
      vtkHeightFieldShadowHeight::SWEEP);
  }
}

INSTANTIATE_TEST_SUITE_P(All, StabilityOfFilters,
  ::testing::Combine(
    ::testing::ValuesIn(StabilityScenes()), ::testing::Values(Heights::Float, Heights::Double)),
  [](const auto& parameters)
  {
    return std::string(std::get<0>(parameters.param).Name) +
      (std::get<1>(parameters.param) == Heights::Float ? "OfFloats" : "OfDoubles");
  });

} // namespace
} // namespace testing
} // namespace skyline
