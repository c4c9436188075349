// SPDX-License-Identifier: BSD-3-Clause
// Real skies, compared with numbers that were computed independently, and the irradiance of their
// series by the number of bands. Prints the table of Documentation/harmonics.md.
#include "Sky/LightMap.h"

#include "Data/LightMapImage.h"
#include "Harmonics/SphericalHarmonics.h"
#include "Shared/Constants.h"
#include "Testing/Module/Harmonics/SphereQuadrature.h"
#include "Testing/Module/NumberTable.h"
#include "Testing/Module/Sky/LightMapTesting.h"
#include "vtkSkylineLightMapReader.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

/// The maps of the tests are means over 8 x 8 pixels of the maps of the reference. A sun can lie
/// half a pixel, 1.4 degrees, from the centre of its pixel.
constexpr double HalfPixel = Pi / 128.0;

/// The resulting error of irradiance, plus the truncation to 8 bits in the file.
constexpr double IrradianceBound = HalfPixel + 1.0 / 128.0;

/// The same for a coefficient of band l, whose harmonics change by l per radian, relative to the
/// constant's.
constexpr double CoefficientBound(int l)
{
  return HalfPixel * l + 1.0 / 128.0;
}

class RealMaps : public ::testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    const std::string path =
      std::string(SKYLINE_TEST_DATA) + "/light-maps/" + GetParam() + "_128.hdr";
    this->Reader->SetFileName(path.c_str());
    this->Reader->Update();
    this->Map = ViewLightMap(this->Reader->GetOutput());
    this->Original = std::string("pmndrs_") + GetParam() + ".hdr";
  }

  vtkNew<vtkSkylineLightMapReader> Reader;
  LightMap Map;
  std::string Original; ///< the name in the tables
};

TEST_P(RealMaps, CoefficientsOfTheReference)
{
  const std::vector<double> coefficients = ProjectLightMap(this->Map, 5);
  int count = 0;
  double constant = 0.0;
  for (const TableRow& row : ReadTable("light-maps/env_sh_coefficients_order4.csv"))
  {
    if (row.at("file") != this->Original)
    {
      continue;
    }
    const int index = std::stoi(row.at("index"));
    const int l = std::stoi(row.at("l"));
    const double expected[3] = { Number(row, "R"), Number(row, "G"), Number(row, "B") };
    constant = index == 0 ? expected[0] : constant;
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(coefficients[25 * c + index], expected[c], CoefficientBound(l) * constant)
        << index;
    }
    ++count;
  }
  EXPECT_EQ(count, 25);
}

TEST_P(RealMaps, IrradianceOfTheReference)
{
  const LightMapDirection normals[6] = { { 0, 0, 1 }, { 0, 0, -1 }, { 0, 1, 0 }, { 0, -1, 0 },
    { 1, 0, 0 }, { -1, 0, 0 } };
  int count = 0;
  for (const TableRow& row : ReadTable("light-maps/env_irradiance_6_normals.csv"))
  {
    if (row.at("file") != this->Original)
    {
      continue;
    }
    ASSERT_LT(count, 6);
    const std::array<double, 3> irradiance = BruteIrradiance(this->Map, normals[count]);
    EXPECT_NEAR(irradiance[0] / Number(row, "E_R"), 1.0, IrradianceBound) << row.at("normal");
    EXPECT_NEAR(irradiance[1] / Number(row, "E_G"), 1.0, IrradianceBound) << row.at("normal");
    EXPECT_NEAR(irradiance[2] / Number(row, "E_B"), 1.0, IrradianceBound) << row.at("normal");
    ++count;
  }
  EXPECT_EQ(count, 6);
}

INSTANTIATE_TEST_SUITE_P(LightMaps, RealMaps, ::testing::Values("sky", "sunset"));

/// Normals up to 60 degrees from the vertical, in all azimuths.
std::vector<LightMapDirection> TiltedNormals()
{
  std::vector<LightMapDirection> normals{ { 0, 0, 1 } };
  for (const double tilt : { 15.0, 30.0, 45.0, 60.0 })
  {
    for (int k = 0; k < 12; ++k)
    {
      const double t = tilt * RadiansPerDegree, azimuth = k * Pi / 6.0;
      normals.push_back(
        { std::sin(t) * std::sin(azimuth), std::sin(t) * std::cos(azimuth), std::cos(t) });
    }
  }
  return normals;
}

/// The part of a map that open level ground sees: the half above the horizontal plane, with or
/// without the pixels brighter than a multiple of the mean (the sun).
OwnedMap UpperHalf(const LightMap& map, bool sun)
{
  OwnedMap half(map.Columns, map.Rows);
  for (std::ptrdiff_t row = 0; row < map.Rows / 2; ++row)
  {
    std::copy_n(map.Pixel(row, 0), 3 * map.Columns, half.Pixel(row, 0));
  }
  const float limit = static_cast<float>(5.0 * Energy(half.View())[1] / (2.0 * Pi));
  for (std::size_t i = 0; !sun && i < half.Values.size(); i += 3)
  {
    if (half.Values[i + 1] > limit)
    {
      half.Values[i] = half.Values[i + 1] = half.Values[i + 2] = 0.0f;
    }
  }
  return half;
}

struct OrderError
{
  double Root = 0.0, Greatest = 0.0; ///< relative to the irradiance of level ground
};

/// Green irradiance on open ground. Compares the sum over `bands` bands of TransferSH (hemisphere
/// times clamped cosine, by quadrature) times the coefficients of the map with the sum over all
/// pixels.
OrderError ErrorOf(int bands, const LightMap& map)
{
  const int count = HarmonicCount(bands);
  const std::vector<double> light = ProjectLightMap(map, bands);
  const double level = BruteIrradiance(map, { 0, 0, 1 })[1];
  const std::vector<LightMapDirection> normals = TiltedNormals();
  OrderError error;
  for (const LightMapDirection& n : normals)
  {
    std::vector<double> transfer(count, 0.0), values(count);
    VisitSphere(48, 0.0,
      [&](double x, double y, double z, double weight)
      {
        const double cosine = n.X * x + n.Y * y + n.Z * z;
        if (cosine > 0.0)
        {
          EvaluateHarmonics(bands, x, y, z, values.data());
          for (int i = 0; i < count; ++i)
          {
            transfer[i] += weight * cosine * values[i];
          }
        }
      });
    const double sum =
      std::inner_product(transfer.begin(), transfer.end(), light.begin() + count, 0.0);
    const double difference = (sum - BruteIrradiance(map, n)[1]) / level;
    error.Root += difference * difference / static_cast<double>(normals.size());
    error.Greatest = std::max(error.Greatest, std::abs(difference));
  }
  error.Root = std::sqrt(error.Root);
  return error;
}

TEST_P(RealMaps, ErrorOfTheOrders)
{
  for (const bool sun : { true, false })
  {
    const OwnedMap half = UpperHalf(this->Map, sun);
    double first = 0.0, last = 0.0;
    for (int bands = 2; bands <= MaxHarmonicBands; ++bands)
    {
      const OrderError error = ErrorOf(bands, half.View());
      std::printf("%s %s sun, %d bands: rms %.1f %%, greatest %.1f %% of level irradiance\n",
        GetParam(), sun ? "with" : "without", bands, 100.0 * error.Root, 100.0 * error.Greatest);
      first = bands == 2 ? error.Root : first;
      last = error.Root;
    }
    EXPECT_LT(last, 0.5 * first) << "more bands, less error";
  }
}

} // namespace
} // namespace testing
} // namespace skyline
