// SPDX-License-Identifier: BSD-3-Clause
// On a level square the trust is a share of azimuths: all of them in the middle, a half at an edge,
// a quarter at a corner. Rays along the edge count.
#include "FilterTesting.h"

#include "vtkHeightFieldSkyView.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace skyline
{
namespace testing
{
namespace
{

constexpr int Azimuths = 72;
constexpr double Step = 10.0; // metres

/// An arc can contain one azimuth more or less than its share, and the sum is a float.
constexpr double OneAzimuth = 1.001 / Azimuths;

constexpr float Along(int quarters)
{
  const int whole = quarters * Azimuths / 4;
  return static_cast<float>(whole + 1) / Azimuths;
}

class Trust
{
public:
  Trust(
    const oracle::OracleField& field, double distance, int method = vtkHeightFieldAlgorithm::EXACT)
    : Columns(field.Columns)
  {
    this->Sky->SetInputData(ImageOf<vtkFloatArray>(field));
    this->Sky->FlatOn();
    this->Sky->SetMethod(method);
    this->Sky->SetNumberOfAzimuths(Azimuths);
    this->Sky->EdgeTrustOn();
    this->Sky->AutoEdgeDistanceOff();
    this->Sky->SetEdgeDistance(distance);
    this->Sky->Update();
  }
  float At(std::ptrdiff_t column, std::ptrdiff_t row)
  {
    return ArrayOf(this->Sky, "EdgeTrust")->GetValue(row * this->Columns + column);
  }

private:
  vtkNew<vtkHeightFieldSkyView> Sky;
  std::ptrdiff_t Columns;
};

TEST(EdgeTrust, LevelSquare)
{
  const oracle::OracleField field = shapes::Plane(41, 41, Step, 0.0, 0.0);
  for (const double distance : { 0.0, Step, 55.0, 100.0 })
  {
    Trust trust(field, distance);
    EXPECT_EQ(trust.At(20, 20), 1.0f) << distance;
    EXPECT_EQ(trust.At(20, 0), Along(2)) << distance;
    EXPECT_EQ(trust.At(40, 20), Along(2)) << distance;
    EXPECT_EQ(trust.At(0, 0), Along(1)) << distance;
    EXPECT_EQ(trust.At(40, 40), Along(1)) << distance;
  }
}

// At the distance e from one edge, the rays that leave the data within d form the arc 2 acos(e /
// d).
TEST(EdgeTrust, ArcsBesideAnEdge)
{
  Trust trust(shapes::Plane(201, 201, Step, 0.0, 0.0), 300.0);
  for (const int posts : { 5, 15, 25, 29 })
  {
    const double arc = 2.0 * std::acos(posts * Step / 300.0) / (2.0 * Pi);
    EXPECT_NEAR(trust.At(posts, 100), 1.0 - arc, OneAzimuth) << posts;
    EXPECT_NEAR(trust.At(100, 200 - posts), 1.0 - arc, OneAzimuth) << posts;
  }
  EXPECT_EQ(trust.At(30, 100), 1.0f);
  EXPECT_EQ(trust.At(100, 31), 1.0f);
}

TEST(EdgeTrust, MissingPostsAtTheRimAreAnEdgeAndHolesAreNot)
{
  constexpr double Nan = std::numeric_limits<double>::quiet_NaN();
  oracle::OracleField field = shapes::Plane(61, 61, Step, 0.0, 0.0);
  for (std::ptrdiff_t row = 0; row < 61; ++row)
  {
    for (std::ptrdiff_t column = 0; column < 61; ++column)
    {
      const bool hole = std::abs(column - 30) < 3 && std::abs(row - 40) < 3;
      if (column < 10 || hole)
      {
        field.Heights[static_cast<std::size_t>(row * 61 + column)] = Nan;
      }
    }
  }
  for (const int method : { vtkHeightFieldAlgorithm::EXACT, vtkHeightFieldAlgorithm::FAST,
         vtkHeightFieldAlgorithm::SWEEP, vtkHeightFieldAlgorithm::PYRAMID })
  {
    Trust trust(field, 100.0, method);
    EXPECT_TRUE(std::isnan(trust.At(5, 30)));
    EXPECT_TRUE(std::isnan(trust.At(30, 40)));
    // Where the edge lies inside the field, the nearest post decides: half a post is 3 degrees
    // here. Sweep and pyramid find a horizon beyond the edge, from interpolated heights.
    if (method <= vtkHeightFieldAlgorithm::FAST)
    {
      EXPECT_NEAR(trust.At(10, 30), 0.5, 3.0 * OneAzimuth) << method;
    }
    EXPECT_EQ(trust.At(30, 30), 1.0f) << method;
    EXPECT_EQ(trust.At(30, 34), 1.0f) << method;
  }
}

TEST(EdgeTrust, AutomaticDistanceIsATenthOfTheShorterSideOrAKilometre)
{
  const oracle::OracleField small = shapes::Plane(101, 41, Step, 0.0, 0.0); // 1000 m by 400 m
  vtkNew<vtkHeightFieldSkyView> sky;
  sky->SetInputData(ImageOf<vtkFloatArray>(small));
  sky->SetNumberOfAzimuths(Azimuths);
  sky->EdgeTrustOn();
  sky->Update();
  Trust tenth(small, 40.0);
  for (const std::ptrdiff_t row : { 0, 2, 3, 4, 5 })
  {
    EXPECT_EQ(ArrayOf(sky, "EdgeTrust")->GetValue(row * 101 + 50), tenth.At(50, row)) << row;
  }
  const oracle::OracleField large = shapes::Plane(61, 61, 500.0, 0.0, 0.0); // 30 km
  sky->SetInputData(ImageOf<vtkFloatArray>(large));
  sky->Update();
  Trust kilometre(large, 1000.0);
  for (const std::ptrdiff_t row : { 0, 1, 2, 3 })
  {
    EXPECT_EQ(ArrayOf(sky, "EdgeTrust")->GetValue(row * 61 + 30), kilometre.At(30, row)) << row;
  }
}

TEST(EdgeTrust, ChangesNoOtherQuantityAndIsOffAtFirst)
{
  const auto image = ImageOf<vtkFloatArray>(shapes::Plane(33, 29, Step, 0.1, 0.3));
  vtkNew<vtkHeightFieldSkyView> plain, with;
  plain->SetInputData(image);
  with->SetInputData(image);
  with->EdgeTrustOn();
  plain->Update();
  with->Update();
  EXPECT_EQ(ArrayOf(plain, "EdgeTrust"), nullptr);
  for (const char* name :
    { "SkyViewFactor", "SkyViewFactorHorizontal", "VisibleSkyFraction", "PositiveOpenness" })
  {
    for (vtkIdType post = 0; post < image->GetNumberOfPoints(); ++post)
    {
      ASSERT_EQ(ArrayOf(plain, name)->GetValue(post), ArrayOf(with, name)->GetValue(post)) << name;
    }
  }
}

TEST(EdgeTrust, DistancesThatAreNone)
{
  for (const double distance : { -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    vtkNew<vtkHeightFieldSkyView> sky;
    vtkNew<ErrorCatcher> errors;
    errors->Watch(sky);
    sky->SetInputData(ImageOf<vtkFloatArray>(shapes::Plane(5, 5, Step, 0.0, 0.0)));
    sky->EdgeTrustOn();
    sky->AutoEdgeDistanceOff();
    sky->SetEdgeDistance(distance);
    sky->Update();
    EXPECT_NE(errors->Text.find("the edge distance is "), std::string::npos) << errors->Text;
  }
}

} // namespace
} // namespace testing
} // namespace skyline
