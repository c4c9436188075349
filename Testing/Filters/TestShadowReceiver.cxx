// SPDX-License-Identifier: BSD-3-Clause
// Light on points above the terrain and on the terrain itself.
#include "FilterTesting.h"

#include "vtkHeightFieldReader.h"
#include "vtkHeightFieldShadowHeight.h"
#include "vtkHeightFieldShadowReceiver.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

constexpr double Elevation = 20.0, Radius = 0.5;

// A ridge of 100 m in the east of a plain. The origin of the image is not that of its coordinates.
vtkSmartPointer<vtkImageData> Ridge()
{
  oracle::OracleField field = shapes::Plane(201, 31, 2.0, 0.0, 0.0);
  for (std::ptrdiff_t row = 0; row < field.Rows; ++row)
  {
    field.At(200, row) = 100.0;
  }
  const auto image = ImageOf<vtkDoubleArray>(field);
  image->SetOrigin(5.0e5, 4.0e6, 0.0);
  return image;
}

double Tangent(double degrees)
{
  return std::tan(degrees * RadiansPerDegree);
}

struct Scene
{
  vtkNew<vtkHeightFieldShadowHeight> Map;
  vtkNew<vtkHeightFieldShadowReceiver> Receiver;

  explicit Scene(vtkImageData* image)
  {
    this->Map->SetInputData(image);
    this->Map->SetSunAzimuth(90.0);
    this->Map->SetSunElevation(Elevation);
    this->Map->SetSunAngularRadius(Radius);
    this->Map->BelowTerrainOn();
    this->Receiver->SetShadowConnection(this->Map->GetOutputPort());
  }

  // The light at points, given in metres from the ridge of Ridge() or in the coordinates of the
  // image.
  std::vector<double> Lit(const std::vector<std::array<double, 3>>& places)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const auto& place : places)
    {
      points->InsertNextPoint(place.data());
    }
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(points);
    this->Receiver->SetInputData(cloud);
    this->Receiver->Update();
    auto* output = vtkPointSet::SafeDownCast(this->Receiver->GetOutputDataObject(0));
    vtkDataArray* lit = output->GetPointData()->GetArray("SunVisibility");
    std::vector<double> values;
    for (vtkIdType id = 0; lit != nullptr && id < lit->GetNumberOfTuples(); ++id)
    {
      values.push_back(lit->GetComponent(id, 0));
    }
    return values;
  }
};

std::array<double, 3> Behind(double distance, double height)
{
  return { 5.0e5 + 400.0 - distance, 4.0e6 + 31.3, height };
}

TEST(ShadowReceiver, HardShadowOfARidge)
{
  Scene scene(Ridge());
  for (const double distance : { 7.0, 50.3, 199.9 })
  {
    const double shadow = 100.0 - distance * Tangent(Elevation);
    const std::vector<double> lit =
      scene.Lit({ Behind(distance, shadow - 0.01), Behind(distance, shadow + 0.01) });
    EXPECT_EQ(lit[0], 0.0) << distance;
    EXPECT_EQ(lit[1], 1.0) << distance;
  }
}

TEST(ShadowReceiver, PenumbraDepthAsPublished)
{
  Scene scene(Ridge());
  scene.Receiver->SetPenumbraDepth(8.0);
  const double shadow = 100.0 - 60.0 * Tangent(Elevation);
  const std::vector<double> lit =
    scene.Lit({ Behind(60.0, shadow), Behind(60.0, shadow - 2.0), Behind(60.0, shadow - 9.0) });
  EXPECT_NEAR(lit[0], 1.0, 1e-4);
  EXPECT_NEAR(lit[1], 0.75, 1e-4);
  EXPECT_EQ(lit[2], 0.0);
}

// From a point at the height z, the ridge stands at atan((100 - z) / d). The model of chords gives
// the visible part of the disc. Floats near 100 m are 8e-6 m apart; the penumbrae here are at least
// 0.1 m deep.
TEST(ShadowReceiver, PenumbraOfARidgeAtAnyHeight)
{
  Scene scene(Ridge());
  scene.Map->SoftOn();
  for (const double distance : { 7.3, 50.0, 199.9 })
  {
    for (double t = -1.2; t <= 1.2; t += 0.1)
    {
      const double z = 100.0 - distance * Tangent(Elevation + t * Radius);
      const double s = std::clamp(t, -1.0, 1.0);
      const double expected = (std::acos(s) - s * std::sqrt(1.0 - s * s)) / Pi;
      EXPECT_NEAR(scene.Lit({ Behind(distance, z) })[0], expected, 1e-3) << distance << ", " << t;
    }
  }
}

TEST(ShadowReceiver, PointsOutsideAreLit)
{
  Scene scene(Ridge());
  const std::vector<std::array<double, 3>> outside{ { 5.0e5 - 1.0, 4.0e6 + 30.0, -50.0 },
    { 5.0e5 + 401.0, 4.0e6 + 30.0, -50.0 }, { 5.0e5 + 10.0, 4.0e6 - 0.1, -50.0 },
    { std::nan(""), 4.0e6, 0.0 } };
  EXPECT_EQ(scene.Lit(outside), std::vector<double>(4, 1.0));
  scene.Map->SoftOn();
  EXPECT_EQ(scene.Lit(outside), std::vector<double>(4, 1.0));
  // The far corner belongs to the image and is not in shadow.
  EXPECT_EQ(scene.Lit({ { 5.0e5 + 400.0, 4.0e6 + 60.0, 100.0 } })[0], 1.0);
  scene.Map->SetSunElevation(0.0); // half of it above the horizon
  EXPECT_NEAR(scene.Lit(outside)[0], 0.5, 1e-6);
  scene.Map->SetSunElevation(-1.0);
  EXPECT_EQ(scene.Lit(outside)[0], 0.0);
  EXPECT_EQ(scene.Lit({ Behind(60.0, 1.0e5) })[0], 0.0);
  scene.Map->SoftOff();
  EXPECT_EQ(scene.Lit({ Behind(60.0, 1.0e5) })[0], 0.0);
}

TEST(ShadowReceiver, MissingPostsShadeNothing)
{
  const auto image = Ridge();
  image->GetPointData()->GetScalars()->SetComponent(15 * 201 + 170, 0, std::nan(""));
  Scene scene(image);
  // First a point in the triangle beside the missing post, then one at a neighbouring post, where
  // the shadow is known.
  EXPECT_EQ(scene.Lit({ Behind(60.5, 0.0) })[0], 1.0);
  EXPECT_EQ(scene.Lit({ { 5.0e5 + 338.0, 4.0e6 + 30.0, 0.0 } })[0], 0.0);
}

// The points are posts of the terrain: compares the light with that of vtkHeightFieldSunShadow.
struct Difference
{
  double Mean = 0.0, Percentile99 = 0.0;
};

Difference OnTheGround(vtkImageData* image, double azimuth, double elevation)
{
  vtkNew<vtkHeightFieldSunShadow> sun;
  sun->SetInputData(image);
  sun->SetSunAzimuth(azimuth);
  sun->SetSunElevation(elevation);
  sun->Update();
  vtkFloatArray* truth = ArrayOf(sun, "SunVisibility");
  Scene scene(image);
  scene.Map->SetSunAzimuth(azimuth);
  scene.Map->SetSunElevation(elevation);
  scene.Map->SetSunAngularRadius(0.26645);
  scene.Map->SoftOn();
  std::vector<std::array<double, 3>> posts;
  for (vtkIdType post = 0; post < image->GetNumberOfPoints(); ++post)
  {
    std::array<double, 3> place{};
    image->GetPoint(post, place.data());
    place[2] = image->GetPointData()->GetScalars()->GetComponent(post, 0);
    posts.push_back(place);
  }
  const std::vector<double> lit = scene.Lit(posts);
  std::vector<double> differences;
  Difference result;
  for (std::size_t post = 0; post < lit.size(); ++post)
  {
    differences.push_back(std::abs(lit[post] - truth->GetValue(static_cast<vtkIdType>(post))));
    result.Mean += differences.back() / static_cast<double>(lit.size());
  }
  std::sort(differences.begin(), differences.end());
  result.Percentile99 = differences[differences.size() * 99 / 100];
  return result;
}

// The chords use one azimuth of the horizon, the reference nine across the disc. They differ only
// in penumbrae, which contain a few percent of the posts, by an amount that depends on the tilt of
// the horizon.
constexpr double MeanBound = 0.002;
constexpr double PercentileBound = 0.02;

TEST(ShadowReceiver, AgreesWithSunVisibilityOnTheGround)
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(SKYLINE_TEST_DATA "/exact/sthelens_crop160_dem.tif");
  reader->Update();
  double mean = 0.0, percentile = 0.0;
  for (const double azimuth : { 30.0, 100.0, 225.0, 290.0 })
  {
    for (const double elevation : { 5.0, 13.0, 25.0 })
    {
      const Difference difference = OnTheGround(reader->GetOutput(), azimuth, elevation);
      EXPECT_LT(difference.Mean, MeanBound) << azimuth << ", " << elevation;
      EXPECT_LT(difference.Percentile99, PercentileBound) << azimuth << ", " << elevation;
      mean = std::max(mean, difference.Mean);
      percentile = std::max(percentile, difference.Percentile99);
    }
  }
  RecordProperty("mean", std::to_string(mean));
  RecordProperty("99 %", std::to_string(percentile));
}

// Vertical edges of houses cut the disc from the side, which chords of one azimuth cannot describe:
// such a post counts as lit or dark although half of the disc is visible.
constexpr double HousesMeanBound = 0.01;

TEST(ShadowReceiver, AgreesWithSunVisibilityAmongHouses)
{
  const auto houses = ImageOf<vtkFloatArray>(shapes::RandomBoxes(200, 180, 0.5, 60, 20, 12.0, 5));
  double mean = 0.0, percentile = 0.0;
  for (const double azimuth : { 30.0, 90.0, 225.0, 290.0 })
  {
    for (const double elevation : { 13.0, 25.0, 45.0 })
    {
      const Difference difference = OnTheGround(houses, azimuth, elevation);
      EXPECT_LT(difference.Mean, HousesMeanBound) << azimuth << ", " << elevation;
      mean = std::max(mean, difference.Mean);
      percentile = std::max(percentile, difference.Percentile99);
    }
  }
  RecordProperty("mean", std::to_string(mean));
  RecordProperty("99 %", std::to_string(percentile));
}

TEST(ShadowReceiver, RefusesInOneLine)
{
  const auto refused = [](vtkImageData* image)
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.0, 0.0, 0.0);
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(points);
    vtkNew<vtkHeightFieldShadowReceiver> receiver;
    vtkNew<ErrorCatcher> catcher;
    catcher->Watch(receiver);
    receiver->SetInputData(cloud);
    receiver->SetShadowData(image);
    receiver->Update();
    EXPECT_EQ(catcher->Count, 1);
    return catcher->Text;
  };
  const auto image = Ridge();
  EXPECT_NE(refused(image).find("ShadowSun"), std::string::npos);
  vtkNew<vtkHeightFieldShadowHeight> map;
  map->SetInputData(image);
  map->Update();
  vtkNew<vtkImageData> bare;
  bare->ShallowCopy(map->GetOutput());
  bare->GetPointData()->RemoveArray("ShadowHeight");
  EXPECT_NE(refused(bare).find("point array ShadowHeight"), std::string::npos);
  vtkNew<vtkImageData> line;
  line->SetDimensions(4, 1, 1);
  line->SetFieldData(map->GetOutput()->GetFieldData());
  EXPECT_NE(refused(line).find("2 x 2 posts"), std::string::npos);
}

} // namespace
} // namespace testing
} // namespace skyline
