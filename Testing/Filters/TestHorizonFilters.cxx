// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTesting.h"

#include "Data/ImageGeoreference.h"
#include "vtkHeightFieldHorizon.h"
#include "vtkHeightFieldReader.h"
#include "vtkHeightFieldSkyView.h"
#include "vtkIntArray.h"
#include "vtkSMPTools.h"
#include "vtkShortArray.h"

#include <gdal.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace skyline
{
namespace testing
{
namespace
{

vtkSmartPointer<vtkImageData> Read(const std::string& name)
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName((std::string(SKYLINE_TEST_DATA) + "/exact/" + name).c_str());
  reader->Update();
  return reader->GetOutput();
}

// Reads a band of a reference raster, row by row from the south. The reader does not apply, because
// the values are not heights.
std::vector<float> ReadBand(const std::string& name, int band)
{
  GDALAllRegister();
  const std::string file = std::string(SKYLINE_TEST_DATA) + "/exact/" + name;
  GDALDatasetH raster = GDALOpen(file.c_str(), GA_ReadOnly);
  EXPECT_NE(raster, nullptr) << file;
  const int columns = GDALGetRasterXSize(raster);
  const int rows = GDALGetRasterYSize(raster);
  std::vector<float> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row)
  {
    float* line = values.data() + static_cast<std::ptrdiff_t>(rows - 1 - row) * columns;
    EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(raster, band), GF_Read, 0, row, columns, 1, line,
                columns, 1, GDT_Float32, 0, 0),
      CE_None);
  }
  GDALClose(raster);
  return values;
}

// The reference is an independent implementation on the same triangles. Its file is rounded to 0.01
// degrees, which alone makes an RMS error of 0.01 / sqrt(12) = 0.0029 and errors up to 0.005.
TEST(HorizonFilter, EqualsTheReferenceOfStHelens)
{
  const auto dem = Read("sthelens_crop160_dem.tif");
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputData(dem);
  filter->FlatOn();
  filter->Update();
  vtkFloatArray* horizon = ArrayOf(filter, "HorizonElevation");
  ASSERT_NE(horizon, nullptr);
  ASSERT_EQ(horizon->GetNumberOfComponents(), 36);
  double squares = 0.0;
  double worst = 0.0;
  for (int band = 0; band < 36; ++band)
  {
    const auto reference = ReadBand("sthelens_crop160_horizon_exactTIN_36az.tif", band + 1);
    for (vtkIdType post = 0; post < dem->GetNumberOfPoints(); ++post)
    {
      const double error =
        horizon->GetComponent(post, band) - 0.01 * reference[static_cast<std::size_t>(post)];
      squares += error * error;
      worst = std::max(worst, std::abs(error));
    }
  }
  const double count = 36.0 * static_cast<double>(dem->GetNumberOfPoints());
  EXPECT_LT(std::sqrt(squares / count), 0.0030);
  EXPECT_LT(worst, 0.0052); // rounding of the file and of heights in floats
}

TEST(SkyViewFilter, EqualsTheReferenceOfStHelens)
{
  const auto dem = Read("sthelens_crop160_dem.tif");
  vtkNew<vtkHeightFieldSkyView> filter;
  filter->SetInputData(dem);
  filter->SetNumberOfAzimuths(36);
  filter->FlatOn();
  filter->Update();
  const char* names[] = { "SkyViewFactorHorizontal", "VisibleSkyFraction", "PositiveOpenness" };
  const double bounds[] = { 1.0e-6, 1.0e-6, 1.0e-4 }; // the reference is float32
  for (int k = 0; k < 3; ++k)
  {
    const auto reference = ReadBand("sthelens_crop160_svf_exactTIN_36az.tif", k + 1);
    vtkFloatArray* found = ArrayOf(filter, names[k]);
    ASSERT_NE(found, nullptr);
    for (vtkIdType post = 0; post < dem->GetNumberOfPoints(); ++post)
    {
      ASSERT_NEAR(found->GetValue(post), reference[static_cast<std::size_t>(post)], bounds[k])
        << names[k];
    }
  }
}

// The tilted sky view of a plane, far from its edges: on an infinite plane it is (1 + cos s)/2. On
// a finite plane, the uphill azimuths still see the plane up to its edge.
TEST(SkyViewFilter, TiltedPlane)
{
  const double slope = std::tan(30.0 * Pi / 180.0);
  vtkNew<vtkHeightFieldSkyView> filter;
  filter->SetInputData(ImageOf<vtkDoubleArray>(shapes::Plane(41, 41, 10.0, slope, 0.0)));
  filter->SetNumberOfAzimuths(360);
  filter->Update();
  const vtkIdType middle = 20 * 41 + 20;
  // Midpoint sums over 360 azimuths of a function with two kinks: h^2 f'' / 12 is less than 1e-4.
  EXPECT_NEAR(
    ArrayOf(filter, "SkyViewFactor")->GetValue(middle), 0.5 + 0.5 * std::cos(Pi / 6.0), 1.0e-4);
  EXPECT_NEAR(ArrayOf(filter, "VisibleSkyFraction")->GetValue(middle), 1.0 - 30.0 / 180.0, 1.0e-4);
}

TEST(SkyViewFilter, AddsWhatIsWantedAlone)
{
  vtkNew<vtkHeightFieldSkyView> filter;
  filter->SetInputData(ImageOf<vtkFloatArray>(shapes::Fractal(40, 30, 10.0, 100.0)));
  filter->SkyViewFactorOff();
  filter->PositiveOpennessOff();
  filter->VisibleSkyFractionOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 2);
  EXPECT_NE(ArrayOf(filter, "SkyViewFactorHorizontal"), nullptr);
}

TEST(Filters, GiveTheSameBitsOnAnyNumberOfThreads)
{
  oracle::OracleField field = shapes::Fractal(301, 257, 10.0, 900.0, 4);
  shapes::RemoveIslands(field, 6, 4, 2);
  const auto image = ImageOf<vtkFloatArray>(field);
  std::vector<float> first;
  for (int threads = 1; threads <= 8; ++threads)
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]()
      {
        vtkNew<vtkHeightFieldHorizon> horizon;
        horizon->SetInputData(image);
        horizon->SetNumberOfAzimuths(8);
        horizon->Update();
        vtkNew<vtkHeightFieldSkyView> sky;
        sky->SetInputData(image);
        sky->SetNumberOfAzimuths(9);
        sky->Update();
        std::vector<float> bits;
        for (vtkFloatArray* array : { ArrayOf(horizon, "HorizonElevation"),
               ArrayOf(sky, "SkyViewFactor"), ArrayOf(sky, "PositiveOpenness") })
        {
          bits.insert(
            bits.end(), array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues());
        }
        if (first.empty())
        {
          first = bits;
        }
        ASSERT_EQ(first.size(), bits.size());
        EXPECT_EQ(std::memcmp(first.data(), bits.data(), bits.size() * sizeof(float)), 0)
          << threads << " threads";
      });
  }
}

TEST(Filters, TakeEveryTypeOfHeight)
{
  oracle::OracleField field = shapes::Fractal(60, 50, 10.0, 900.0, 4);
  for (double& height : field.Heights)
  {
    height = std::nearbyint(height);
  }
  const auto horizonOf = [](vtkImageData* image)
  {
    vtkNew<vtkHeightFieldHorizon> filter;
    filter->SetInputData(image);
    filter->SetNumberOfAzimuths(5);
    filter->Update();
    vtkFloatArray* array = ArrayOf(filter, "HorizonElevation");
    return std::vector<float>(
      array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues());
  };
  const std::vector<float> fromDouble = horizonOf(ImageOf<vtkDoubleArray>(field));
  EXPECT_EQ(horizonOf(ImageOf<vtkFloatArray>(field)), fromDouble);
  EXPECT_EQ(horizonOf(ImageOf<vtkShortArray>(field)), fromDouble);
  EXPECT_EQ(horizonOf(ImageOf<vtkIntArray>(field)), fromDouble);
  // 1e7 m higher, in double precision: the bits are the same, because integers are exact.
  EXPECT_EQ(horizonOf(ImageOf<vtkDoubleArray>(field, 1.0e7)), fromDouble);
}

TEST(Filters, DoNotDependOnTheOrigin)
{
  const auto image = ImageOf<vtkFloatArray>(shapes::Fractal(60, 50, 10.0, 900.0, 4));
  vtkNew<vtkHeightFieldHorizon> here;
  here->SetInputData(image);
  here->Update();
  vtkNew<vtkImageData> moved;
  moved->ShallowCopy(image);
  moved->SetOrigin(1.0e7, -1.0e7, 0.0);
  vtkNew<vtkHeightFieldHorizon> there;
  there->SetInputData(moved);
  there->Update();
  vtkFloatArray* a = ArrayOf(here, "HorizonElevation");
  vtkFloatArray* b = ArrayOf(there, "HorizonElevation");
  EXPECT_EQ(std::memcmp(a->GetPointer(0), b->GetPointer(0),
              static_cast<std::size_t>(a->GetNumberOfValues()) * sizeof(float)),
    0);
}

// A raster in degrees, whose rows have different widths: the horizon of each row is that of the
// oracle with the spacing of the row. The bands of rows stay within 0.05 % of the spacing: 0.0143
// degrees at 45 degrees.
TEST(HorizonFilter, RowsHaveTheirOwnSpacing)
{
  oracle::OracleField field = shapes::Fractal(50, 90, 100.0, 2000.0, 6);
  const auto image = ImageOf<vtkDoubleArray>(field);
  Georeference place;
  place.Columns = field.Columns;
  place.Rows = field.Rows;
  for (std::ptrdiff_t row = 0; row < field.Rows; ++row)
  {
    place.RowSpacingX.push_back(100.0 * std::cos(static_cast<double>(row) * 0.015));
    place.RowSpacingY.push_back(100.0);
  }
  StoreGeoreference(place, image);
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputData(image);
  filter->SetNumberOfAzimuths(7);
  filter->Update();
  vtkFloatArray* horizon = ArrayOf(filter, "HorizonElevation");
  for (const std::ptrdiff_t row : { 0, 20, 44, 70, 89 })
  {
    field.SpacingX = place.RowSpacingX[static_cast<std::size_t>(row)];
    for (int k = 0; k < 7; ++k)
    {
      const double azimuth = 2.0 * Pi * k / 7.0;
      for (const std::ptrdiff_t column : { 3, 25, 40 })
      {
        const double truth =
          oracle::ElevationDegrees(oracle::HorizonSlope(field, column, row, azimuth));
        EXPECT_NEAR(horizon->GetComponent(row * field.Columns + column, k), truth, 0.0144 + 1e-4);
      }
    }
  }
}

TEST(HorizonFilter, CurvatureSinksFarTerrain)
{
  // Level ground 100 km wide: seen from the middle, its edge lies (1 - k) d / 2R radians below the
  // horizontal.
  const oracle::OracleField field = shapes::Plane(101, 101, 1000.0, 0.0, 0.0);
  const auto image = ImageOf<vtkDoubleArray>(field);
  Georeference place;
  place.EquatorialRadius = 6371000.0;
  place.Earth = true;
  place.Columns = place.Rows = 101;
  place.LatticeColumns = place.LatticeRows = 2;
  const double side = 100000.0 / 6371000.0 * 180.0 / Pi; // degrees, as the spacing
  place.Longitude = { 0.0, side, 0.0, side };
  place.Latitude = { 0.0, 0.0, side, side };
  StoreGeoreference(place, image);
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputData(image);
  filter->SetNumberOfAzimuths(4);
  filter->Update();
  const vtkIdType middle = 50 * 101 + 50;
  // On a plain that sinks with distance, the nearest post is the highest.
  const double expected = -std::atan(0.87 * 1000.0 / (2.0 * 6371000.0)) * 180.0 / Pi;
  EXPECT_NEAR(ArrayOf(filter, "HorizonElevation")->GetComponent(middle, 0), expected, 1.0e-6);
  filter->FlatOn();
  filter->Update();
  EXPECT_EQ(ArrayOf(filter, "HorizonElevation")->GetComponent(middle, 0), 0.0);
}

TEST(HorizonFilter, MissingPostsAreNaN)
{
  oracle::OracleField field = shapes::Fractal(40, 30, 10.0, 100.0);
  field.At(7, 9) = std::nan("");
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputData(ImageOf<vtkFloatArray>(field));
  filter->Update();
  vtkFloatArray* horizon = ArrayOf(filter, "HorizonElevation");
  for (vtkIdType post = 0; post < horizon->GetNumberOfTuples(); ++post)
  {
    EXPECT_EQ(std::isnan(horizon->GetComponent(post, 5)), post == 9 * 40 + 7);
  }
}

} // namespace
} // namespace testing
} // namespace skyline
