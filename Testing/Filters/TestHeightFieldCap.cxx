// SPDX-License-Identifier: BSD-3-Clause
// Houses on the height field cast shadows on the ground and on each other.
#include "FilterTesting.h"

#include "vtkCellArray.h"
#include "vtkHeightFieldCap.h"
#include "vtkHeightFieldShadowHeight.h"
#include "vtkHeightFieldShadowReceiver.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

constexpr double Exact = 1e-9;

// A level quadrilateral around (x0, y0) .. (x1, y1).
void AddRoof(vtkPolyData* objects, const std::array<double, 4>& box, double low, double high)
{
  vtkPoints* points = objects->GetPoints();
  const vtkIdType corners[4] = { points->InsertNextPoint(box[0], box[1], low),
    points->InsertNextPoint(box[2], box[1], high), points->InsertNextPoint(box[2], box[3], high),
    points->InsertNextPoint(box[0], box[3], low) };
  objects->GetPolys()->InsertNextCell(4, corners);
}

vtkSmartPointer<vtkPolyData> NoObjects()
{
  auto objects = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  objects->SetPoints(points);
  objects->SetPolys(polygons);
  return objects;
}

// A plain at 10 m with posts every half metre, starting at (100, 200).
vtkSmartPointer<vtkImageData> Plain()
{
  oracle::OracleField field = shapes::Plane(81, 61, 0.5, 0.0, 0.0);
  field.At(3, 5) = std::nan("");
  const auto image = ImageOf<vtkFloatArray>(field, 10.0);
  image->SetOrigin(100.0, 200.0, 0.0);
  return image;
}

TEST(HeightFieldCap, RaisesThePostsUnderARoof)
{
  const auto objects = NoObjects();
  AddRoof(objects, { 105.0, 210.0, 115.0, 220.0 }, 14.0, 18.0); // rises eastwards
  AddRoof(objects, { 104.0, 209.0, 116.0, 221.0 }, 3.0, 3.0);   // a cellar
  AddRoof(objects, { 100.1, 200.1, 100.4, 229.9 }, 50.0, 50.0); // between posts
  AddRoof(objects, { 90.0, 190.0, 102.0, 203.0 }, 20.0, 20.0);  // partly outside, over a hole
  AddRoof(objects, { 500.0, 500.0, 510.0, 510.0 }, 20.0, 20.0); // outside
  AddRoof(objects, { 110.0, 210.0, 110.0, 220.0 }, 0.0, 99.0);  // vertical
  vtkNew<vtkHeightFieldCap> cap;
  cap->SetInputData(Plain());
  cap->SetObjectsData(objects);
  cap->Update();
  vtkFloatArray* heights = ArrayOf(cap, "Elevation");
  ASSERT_NE(heights, nullptr);
  EXPECT_EQ(cap->GetOutput()->GetPointData()->GetScalars(), heights);
  for (vtkIdType row = 0; row < 61; ++row)
  {
    for (vtkIdType column = 0; column < 81; ++column)
    {
      const double x = 100.0 + 0.5 * static_cast<double>(column);
      const double y = 200.0 + 0.5 * static_cast<double>(row);
      const float height = heights->GetValue(row * 81 + column);
      if (column == 3 && row == 5)
      {
        EXPECT_TRUE(std::isnan(height));
        continue;
      }
      const bool roof = x >= 105.0 && x <= 115.0 && y >= 210.0 && y <= 220.0;
      const bool other = x <= 102.0 && y <= 203.0;
      const double expected = roof ? 14.0 + 0.4 * (x - 105.0) : other ? 20.0 : 10.0;
      EXPECT_NEAR(height, expected, 1e-5) << x << ", " << y;
    }
  }
}

// Figure 8 of the paper: a house with a chimney; the sun is in the west at 45 degrees.
TEST(HeightFieldCap, ChimneyShadesTheRoofAndTheGround)
{
  const auto objects = NoObjects();
  AddRoof(objects, { 110.0, 210.0, 120.0, 220.0 }, 16.0, 16.0);
  AddRoof(objects, { 112.0, 214.0, 113.0, 216.0 }, 19.0, 19.0);
  vtkNew<vtkHeightFieldCap> cap;
  cap->SetInputData(Plain());
  cap->SetObjectsData(objects);
  vtkNew<vtkHeightFieldShadowHeight> map;
  map->SetInputConnection(cap->GetOutputPort());
  map->SetSunAzimuth(270.0);
  map->SetSunElevation(45.0);
  map->BelowTerrainOn();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(114.5, 215.0, 16.0); // roof, 1.5 m behind the chimney of 3 m
  points->InsertNextPoint(117.0, 215.0, 16.0); // roof, 4 m behind it
  points->InsertNextPoint(114.5, 212.0, 16.0); // roof beside the shadow
  points->InsertNextPoint(123.0, 215.0, 10.0); // ground, 3 m behind the house of 6 m
  points->InsertNextPoint(123.0, 215.0, 13.5); // above the shadow of the house there
  points->InsertNextPoint(127.0, 215.0, 10.0); // ground, 7 m behind it
  points->InsertNextPoint(105.0, 215.0, 10.0); // on the sunny side of the house
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkHeightFieldShadowReceiver> receiver;
  receiver->SetInputData(cloud);
  receiver->SetShadowConnection(map->GetOutputPort());
  receiver->Update();
  vtkDataArray* lit = vtkPointSet::SafeDownCast(receiver->GetOutputDataObject(0))
                        ->GetPointData()
                        ->GetArray("SunVisibility");
  const std::vector<double> expected{ 0.0, 1.0, 1.0, 0.0, 1.0, 1.0, 1.0 };
  for (std::size_t k = 0; k < expected.size(); ++k)
  {
    EXPECT_NEAR(lit->GetComponent(static_cast<vtkIdType>(k), 0), expected[k], Exact) << k;
  }
}

TEST(HeightFieldCap, RefusesInOneLine)
{
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 1);
  vtkNew<vtkHeightFieldCap> cap;
  vtkNew<ErrorCatcher> catcher;
  catcher->Watch(cap);
  cap->SetInputData(bare);
  cap->SetObjectsData(NoObjects());
  cap->Update();
  EXPECT_EQ(catcher->Count, 1);
  EXPECT_NE(catcher->Text.find("no heights"), std::string::npos);
}

} // namespace
} // namespace testing
} // namespace skyline
