// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ImageGeoreference.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

namespace
{

skyline::Georeference Sample()
{
  skyline::Georeference place;
  place.Crs = "PROJCRS[\"\xc3\xa9\"]";
  place.GeoTransform = { { 500000.25, 30.0, 0.0, 5.1e6, 0.0, -30.0 } };
  place.HasGeoTransform = true;
  place.EquatorialRadius = 6378206.4;
  place.Flattening = 1.0 / 294.978698213898;
  place.Earth = true;
  place.Columns = 4;
  place.Rows = 3;
  place.LatticeColumns = 2;
  place.LatticeRows = 3;
  place.Longitude = { 179.0, 181.0, 179.0, 181.0, 179.0, 181.0 };
  place.Latitude = { -1.0, -1.0, 0.0, 0.0, 1.0, 1.0 };
  place.RowSpacingX = { 1.0, 2.0, 3.0 };
  place.RowSpacingY = { 4.0, 5.0, 6.0 };
  return place;
}

void ExpectSame(const skyline::Georeference& a, const skyline::Georeference& b)
{
  EXPECT_EQ(a.Crs, b.Crs);
  EXPECT_EQ(a.GeoTransform, b.GeoTransform);
  EXPECT_EQ(a.HasGeoTransform, b.HasGeoTransform);
  EXPECT_EQ(a.EquatorialRadius, b.EquatorialRadius);
  EXPECT_EQ(a.Flattening, b.Flattening);
  EXPECT_EQ(a.Earth, b.Earth);
  EXPECT_EQ(a.Columns, b.Columns);
  EXPECT_EQ(a.Rows, b.Rows);
  EXPECT_EQ(a.LatticeColumns, b.LatticeColumns);
  EXPECT_EQ(a.LatticeRows, b.LatticeRows);
  EXPECT_EQ(a.Longitude, b.Longitude);
  EXPECT_EQ(a.Latitude, b.Latitude);
  EXPECT_EQ(a.RowSpacingX, b.RowSpacingX);
  EXPECT_EQ(a.RowSpacingY, b.RowSpacingY);
}

} // namespace

TEST(FieldData, RoundTripIsExact)
{
  vtkNew<vtkImageData> image;
  skyline::StoreGeoreference(Sample(), image);
  ExpectSame(skyline::LoadGeoreference(image), Sample());
}

TEST(FieldData, StoringReplacesAll)
{
  vtkNew<vtkImageData> image;
  skyline::StoreGeoreference(Sample(), image);
  skyline::Georeference bare;
  bare.Columns = 7;
  bare.Rows = 8;
  skyline::StoreGeoreference(bare, image);
  EXPECT_EQ(image->GetFieldData()->GetNumberOfArrays(), 1);
  ExpectSame(skyline::LoadGeoreference(image), bare);
}

TEST(FieldData, SurvivesAPipelinesShallowCopy)
{
  vtkNew<vtkImageData> image, copy;
  skyline::StoreGeoreference(Sample(), image);
  copy->ShallowCopy(image);
  ExpectSame(skyline::LoadGeoreference(copy), Sample());
}

TEST(FieldData, AnImageWithoutAnyKnowsItsSize)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 3, 1);
  skyline::Georeference bare;
  bare.Columns = 4;
  bare.Rows = 3;
  ExpectSame(skyline::LoadGeoreference(image), bare);
  ExpectSame(skyline::LoadGeoreference(nullptr), skyline::Georeference());
}

TEST(FieldData, MalformedArraysAreIgnored)
{
  vtkNew<vtkImageData> image;
  skyline::StoreGeoreference(Sample(), image);
  for (const char* name : { "GeoTransform", "BodyEllipsoid", "LonLatLattice", "RowSpacing" })
  {
    vtkNew<vtkDoubleArray> wrong;
    wrong->SetName(name);
    wrong->SetNumberOfComponents(2);
    wrong->InsertNextTuple2(1.0, 2.0);
    image->GetFieldData()->AddArray(wrong);
  }
  const skyline::Georeference place = skyline::LoadGeoreference(image);
  EXPECT_FALSE(place.HasGeoTransform);
  EXPECT_EQ(place.EquatorialRadius, 0.0);
  EXPECT_TRUE(place.Longitude.empty());
  EXPECT_EQ(place.LatticeColumns, 0);
  EXPECT_TRUE(place.RowSpacingX.empty());
}

TEST(FieldData, Nodata)
{
  vtkNew<vtkImageData> image;
  double value = 5.0;
  EXPECT_FALSE(skyline::LoadNodataValue(image, value));
  EXPECT_EQ(value, 5.0);
  skyline::StoreNodataValue(-32767.0, image);
  skyline::StoreNodataValue(-9999.0, image);
  EXPECT_TRUE(skyline::LoadNodataValue(image, value));
  EXPECT_EQ(value, -9999.0);
}
