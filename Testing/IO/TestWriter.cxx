// SPDX-License-Identifier: BSD-3-Clause
// The content of the GeoTIFF.
#include "IoTesting.h"

#include "vtkHeightFieldWriter.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkShortArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>
#include <memory>

using namespace skyline_test;

namespace
{

struct Closer
{
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, Closer>;

Dataset Open(const std::string& file)
{
  GDALAllRegister();
  Dataset dataset(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR));
  EXPECT_NE(dataset, nullptr) << file;
  return dataset;
}

double ValueAt(GDALDataset* dataset, int band, int column, int line)
{
  double value = 0.0;
  EXPECT_EQ(dataset->GetRasterBand(band)->RasterIO(
              GF_Read, column, line, 1, 1, &value, 1, 1, GDT_Float64, 0, 0, nullptr),
    CE_None);
  return value;
}

template <typename ArrayT>
void AddArray(vtkImageData* image, const char* name, int components,
  const std::function<double(int, int, int)>& value)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  const int columns = image->GetDimensions()[0];
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      array->SetComponent(
        i, c, value(static_cast<int>(i % columns), static_cast<int>(i / columns), c));
    }
  }
  image->GetPointData()->AddArray(array);
}

double Plane(int column, int row, int component)
{
  return column + 10.0 * row + 100.0 * component;
}

std::string Write(vtkHeightFieldWriter* writer, const std::string& name)
{
  const std::string path = OutputPath(name);
  const Errors errors(writer);
  writer->SetFileName(path.c_str());
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(errors.First(), "");
  EXPECT_EQ(writer->GetErrorCode(), vtkErrorCode::NoError);
  return path;
}

bool SameCrs(GDALDataset* dataset, const std::string& crs)
{
  const OGRSpatialReference expected = CrsFrom(crs);
  return dataset->GetSpatialRef() && dataset->GetSpatialRef()->IsSame(&expected);
}

} // namespace

TEST(Writer, RoundTripKeepsEverything)
{
  const auto reader = Read(DataPath("dem/SainteHelens.tif"));
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputConnection(reader->GetOutputPort());
  const std::string copy = Write(writer, "copy.tif");

  const Dataset before = Open(DataPath("dem/SainteHelens.tif"));
  const Dataset after = Open(copy);
  EXPECT_TRUE(after->GetSpatialRef()->IsSame(before->GetSpatialRef()));
  double expected[6], transform[6];
  before->GetGeoTransform(expected);
  ASSERT_EQ(after->GetGeoTransform(transform), CE_None);
  EXPECT_TRUE(std::equal(expected, expected + 6, transform));
  GDALRasterBand* band = after->GetRasterBand(1);
  EXPECT_EQ(band->GetNoDataValue(), -32767.0);
  EXPECT_STREQ(band->GetDescription(), "Elevation");
  EXPECT_STREQ(band->GetUnitType(), "m");
  EXPECT_EQ(band->GetRasterDataType(), GDT_Float32);
  EXPECT_STREQ(after->GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE"), "DEFLATE");

  std::vector<float> a(327 * 468), b(327 * 468);
  ASSERT_EQ(before->GetRasterBand(1)->RasterIO(
              GF_Read, 0, 0, 327, 468, a.data(), 327, 468, GDT_Float32, 0, 0, nullptr),
    CE_None);
  ASSERT_EQ(band->RasterIO(GF_Read, 0, 0, 327, 468, b.data(), 327, 468, GDT_Float32, 0, 0, nullptr),
    CE_None);
  EXPECT_EQ(a, b);
}

TEST(Writer, EveryKindOfCrsComesBack)
{
  for (const auto& [crs, transform] :
    std::vector<std::pair<std::string, std::vector<double>>>{
      { "EPSG:4326", { -106, 0.001, 0, 41, 0, -0.001 } },
      { "EPSG:26710", { 557805, 30, 0, 5122005, 0, -30 } },
      { "EPSG:2263", { 980000, 10, 0, 200000, 0, -10 } },
      { "EPSG:26910+5703", { 500000, 10, 0, 5100000, 0, -10 } },
      { "EPSG:3857", { -13700000, 1000, 0, 6280000, 0, -1000 } },
      { "EPSG:4807", { 0, 0.01, 0, 50, 0, -0.01 } },
      { "IAU_2015:30100", { 20, 0.01, 0, 60, 0, -0.01 } },
      { "IAU_2015:49910", { 8144000, 100, 0, -272000, 0, -100 } }, { "", { 3, 2, 0, 1, 0, -2 } } })
  {
    Recipe recipe;
    recipe.Crs = crs;
    recipe.Transform = transform;
    const auto reader = Read(Make(recipe));
    vtkNew<vtkHeightFieldWriter> writer;
    writer->SetInputConnection(reader->GetOutputPort());
    const std::string first = Write(writer, "crs.tif");
    const Dataset made = Open("/vsimem/made.tif");
    const Dataset written = Open(first);
    if (crs.empty())
    {
      EXPECT_EQ(written->GetSpatialRef(), nullptr);
    }
    else
    {
      EXPECT_TRUE(written->GetSpatialRef()->IsSame(made->GetSpatialRef())) << crs;
    }
    double back[6];
    ASSERT_EQ(written->GetGeoTransform(back), CE_None);
    EXPECT_TRUE(std::equal(back, back + 6, transform.data())) << crs;
    // The result is the same if a file written by Skyline is read and written again.
    EXPECT_EQ(skyline::LoadGeoreference(Read(first)->GetOutput()).Longitude,
      skyline::LoadGeoreference(reader->GetOutput()).Longitude);
  }
}

// South-up and mirrored files become north-up files with the same posts at the same positions.
TEST(Writer, OutputIsNorthUp)
{
  Recipe recipe;
  recipe.Crs = "EPSG:32610";
  recipe.Transform = { 500050, -10, 0, 5099960, 0, 10 };
  vtkNew<vtkHeightFieldWriter> writer;
  const auto reader = Read(Make(recipe));
  writer->SetInputConnection(reader->GetOutputPort());
  const Dataset dataset = Open(Write(writer, "northup.tif"));
  double transform[6];
  ASSERT_EQ(dataset->GetGeoTransform(transform), CE_None);
  const double expected[6] = { 500000, 10, 0, 5100000, 0, -10 };
  EXPECT_TRUE(std::equal(transform, transform + 6, expected));
  EXPECT_EQ(ValueAt(dataset.get(), 1, 0, 0), recipe.Value(4, 3));
}

TEST(Writer, ACropIsPlacedWhereItWas)
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(DataPath("dem/SainteHelens.tif").c_str());
  const int extent[6] = { 101, 140, 51, 110, 0, 0 };
  reader->UpdateExtent(extent);
  vtkNew<vtkImageData> part;
  part->ShallowCopy(reader->GetOutput());
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputData(part);
  const Dataset crop = Open(Write(writer, "crop.tif"));
  const Dataset whole = Open(DataPath("dem/SainteHelens.tif"));
  double transform[6];
  crop->GetGeoTransform(transform);
  EXPECT_EQ(transform[0], 557805.0 + 101 * 30.0);
  EXPECT_EQ(transform[3], 5122005.0 - 357 * 30.0);
  EXPECT_EQ(ValueAt(crop.get(), 1, 3, 4), ValueAt(whole.get(), 1, 104, 361));
}

TEST(Writer, ArraysInOrderAndComponentsAsBands)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 1);
  AddArray<vtkFloatArray>(image, "Horizon", 3, Plane);
  AddArray<vtkFloatArray>(
    image, "SkyView", 1, [](int column, int row, int) { return 0.01 * (column + row); });
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputData(image);
  writer->AddArray("SkyView");
  writer->AddArray("Horizon");
  writer->SetBandDescription(2, "azimuth 0");
  writer->SetBandUnit(2, "degree");
  const Dataset dataset = Open(Write(writer, "bands.tif"));
  ASSERT_EQ(dataset->GetRasterCount(), 4);
  EXPECT_STREQ(dataset->GetMetadataItem("INTERLEAVE", "IMAGE_STRUCTURE"), "BAND");
  EXPECT_STREQ(dataset->GetRasterBand(1)->GetDescription(), "SkyView");
  EXPECT_STREQ(dataset->GetRasterBand(2)->GetDescription(), "azimuth 0");
  EXPECT_STREQ(dataset->GetRasterBand(3)->GetDescription(), "Horizon 2");
  EXPECT_STREQ(dataset->GetRasterBand(1)->GetUnitType(), "");
  EXPECT_STREQ(dataset->GetRasterBand(2)->GetUnitType(), "degree");
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_EQ(ValueAt(dataset.get(), 2 + c, 4, 0), Plane(4, 3, c)); // the first line is row 3
    EXPECT_EQ(ValueAt(dataset.get(), 2 + c, 1, 3), Plane(1, 0, c));
  }
  EXPECT_EQ(ValueAt(dataset.get(), 1, 2, 1), static_cast<double>(0.04f));
}

// Large enough for tiles and for several blocks and groups of bands, with sizes that are not
// multiples of theirs.
TEST(Writer, ManyBandsInTiles)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(1031, 547, 1);
  AddArray<vtkFloatArray>(image, "Horizon", 36, Plane);
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputData(image);
  const Dataset dataset = Open(Write(writer, "tiles.tif"));
  int blockColumns = 0, blockLines = 0;
  dataset->GetRasterBand(1)->GetBlockSize(&blockColumns, &blockLines);
  EXPECT_EQ(blockColumns, 256);
  EXPECT_EQ(blockLines, 256);
  std::vector<float> line(1031);
  int wrong = 0;
  for (int band = 1; band <= 36; ++band)
  {
    for (int j = 0; j < 547; ++j)
    {
      ASSERT_EQ(dataset->GetRasterBand(band)->RasterIO(
                  GF_Read, 0, j, 1031, 1, line.data(), 1031, 1, GDT_Float32, 0, 0, nullptr),
        CE_None);
      for (int i = 0; i < 1031; ++i)
      {
        wrong += line[static_cast<std::size_t>(i)] != Plane(i, 546 - j, band - 1);
      }
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(Writer, TypesFollowTheArrays)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 1);
  AddArray<vtkUnsignedCharArray>(image, "Bytes", 1, Plane);
  AddArray<vtkShortArray>(image, "Shorts", 1, Plane);
  AddArray<vtkFloatArray>(image, "Floats", 1, Plane);
  AddArray<vtkDoubleArray>(
    image, "Doubles", 1, [](int column, int, int) { return 1e7 + 0.001 * column; });
  const auto typeOf = [&](const std::vector<const char*>& names)
  {
    vtkNew<vtkHeightFieldWriter> writer;
    writer->SetInputData(image);
    for (const char* name : names)
    {
      writer->AddArray(name);
    }
    const Dataset dataset = Open(Write(writer, "types.tif"));
    for (int band = 1; band <= dataset->GetRasterCount(); ++band)
    {
      const bool doubles = std::strcmp(names[static_cast<std::size_t>(band) - 1], "Doubles") == 0;
      EXPECT_EQ(ValueAt(dataset.get(), band, 3, 3), doubles ? 1e7 + 0.003 : 3.0);
      int declared = 0;
      dataset->GetRasterBand(band)->GetNoDataValue(&declared);
      EXPECT_FALSE(declared);
    }
    return dataset->GetRasterBand(1)->GetRasterDataType();
  };
  EXPECT_EQ(typeOf({ "Bytes" }), GDT_Byte);
  EXPECT_EQ(typeOf({ "Shorts" }), GDT_Int16);
  EXPECT_EQ(typeOf({ "Bytes", "Shorts" }), GDT_Int16);
  EXPECT_EQ(typeOf({ "Floats" }), GDT_Float32);
  EXPECT_EQ(typeOf({ "Floats", "Bytes" }), GDT_Float32);
  EXPECT_EQ(typeOf({ "Floats", "Doubles" }), GDT_Float64);
}

TEST(Writer, NodataThatNoResultCanHave)
{
  struct Case
  {
    bool Declared;
    double Input;
    double Height; ///< of one post
    double Expected;
  };
  for (const Case& nodata : { Case{ true, -32767.0, 1.0, -32767.0 }, // the value of the input
         Case{ true, 0.0, 1.0, -9999.0 },                            // 0 is a valid fraction
         Case{ true, -90.0, 1.0, -9999.0 },                          // -90 is a valid angle
         Case{ false, 0.0, 1.0, -9999.0 }, Case{ true, NaN, 1.0, NaN },
         Case{ true, -32767.0, -32767.0, -9999.0 }, // a height has this value
         Case{ false, 0.0, -9999.0, NaN },
         Case{ true, -1.7976931348623157e308, 1.0, -9999.0 } }) // outside the range of float
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(5, 4, 1);
    AddArray<vtkFloatArray>(image, "A", 1,
      [&](int column, int row, int)
      { return column == 0 ? nodata.Height : (column == row ? NaN : 2.0); });
    if (nodata.Declared)
    {
      skyline::StoreNodataValue(nodata.Input, image);
    }
    vtkNew<vtkHeightFieldWriter> writer;
    writer->SetInputData(image);
    const std::string file = Write(writer, "nodata.tif");
    const Dataset dataset = Open(file);
    int declared = 0;
    const double value = dataset->GetRasterBand(1)->GetNoDataValue(&declared);
    EXPECT_TRUE(declared);
    EXPECT_TRUE(value == nodata.Expected || (std::isnan(value) && std::isnan(nodata.Expected)))
      << value << " for " << nodata.Input;
    EXPECT_EQ(ValueAt(dataset.get(), 1, 0, 0), nodata.Height);
    EXPECT_TRUE(std::isnan(HeightAt(Read(file)->GetOutput(), 1, 1)));
    EXPECT_EQ(HeightAt(Read(file)->GetOutput(), 2, 1), 2.0);
  }
}

TEST(Writer, NoNodataWhereNothingIsMissing)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 1);
  AddArray<vtkFloatArray>(image, "A", 1, Plane);
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputData(image);
  const Dataset dataset = Open(Write(writer, "none.tif"));
  int declared = 0;
  dataset->GetRasterBand(1)->GetNoDataValue(&declared);
  EXPECT_FALSE(declared);
}

// A dimensionless band is not in feet, even if the CRS is.
TEST(Writer, VerticalUnitOfTheCrsIsNotTheBands)
{
  Recipe recipe;
  recipe.Crs = "EPSG:2263+6360";
  recipe.Transform = { 980000, 10, 0, 200000, 0, -10 };
  const auto reader = Read(Make(recipe));
  vtkImageData* image = reader->GetOutput();
  AddArray<vtkFloatArray>(image, "SkyView", 1, Plane);
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputData(image);
  writer->AddArray("SkyView");
  writer->AddArray("Elevation");
  const std::string file = Write(writer, "feet.tif");
  const Dataset dataset = Open(file);
  EXPECT_STREQ(dataset->GetRasterBand(1)->GetUnitType(), "1");
  EXPECT_STREQ(dataset->GetRasterBand(2)->GetUnitType(), "m");
  EXPECT_TRUE(SameCrs(dataset.get(), "EPSG:2263+6360"));
  EXPECT_EQ(HeightAt(Read(file, 2)->GetOutput(), 3, 2), HeightAt(image, 3, 2));
}

TEST(Writer, PicturesAreRgb)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 1);
  AddArray<vtkUnsignedCharArray>(
    image, "Colors", 3, [](int column, int row, int c) { return column + 10 * row + 60 * c; });
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputData(image);
  const Dataset dataset = Open(Write(writer, "rgb.tif"));
  ASSERT_EQ(dataset->GetRasterCount(), 3);
  EXPECT_EQ(dataset->GetRasterBand(1)->GetColorInterpretation(), GCI_RedBand);
  EXPECT_EQ(dataset->GetRasterBand(3)->GetColorInterpretation(), GCI_BlueBand);
  EXPECT_EQ(ValueAt(dataset.get(), 3, 4, 0), 154.0);
}

TEST(Writer, CloudOptimized)
{
  const auto reader = Read(DataPath("dem/SainteHelens.tif"));
  const std::string folder = FreshFolder("cog");
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputConnection(reader->GetOutputPort());
  writer->CloudOptimizedOn();
  writer->SetBandUnit(1, "m");
  const std::string file = Write(writer, "cog/cog.tif");
  EXPECT_EQ(FilesIn(folder), std::vector<std::string>{ "cog.tif" });
  const Dataset dataset = Open(file);
  EXPECT_STREQ(dataset->GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE"), "COG");
  EXPECT_TRUE(SameCrs(dataset.get(), "EPSG:26710"));
  EXPECT_EQ(dataset->GetRasterBand(1)->GetNoDataValue(), -32767.0);
  EXPECT_STREQ(dataset->GetRasterBand(1)->GetDescription(), "Elevation");
  EXPECT_STREQ(dataset->GetRasterBand(1)->GetUnitType(), "m");
  const auto again = Read(file);
  EXPECT_EQ(HeightAt(again->GetOutput(), 100, 100), HeightAt(reader->GetOutput(), 100, 100));
}

// Arrays in which VTK stores each component separately, as some filters do.
TEST(Writer, StructureOfArrays)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 1);
  AddArray<vtkSOADataArrayTemplate<float>>(image, "Soa", 2, Plane);
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputData(image);
  const Dataset dataset = Open(Write(writer, "soa.tif"));
  EXPECT_EQ(ValueAt(dataset.get(), 2, 4, 0), Plane(4, 3, 1));
}

// Side files that described the replaced file must not describe the new one.
TEST(Writer, SideFilesOfTheOldFileGo)
{
  const std::string folder = FreshFolder("side");
  Make(Recipe(), folder + "/out.tif");
  for (const char* side : { "/out.tif.aux.xml", "/out.tif.ovr", "/out.tif.msk" })
  {
    VSILFILE* file = VSIFOpenL((folder + side).c_str(), "wb");
    VSIFCloseL(file);
  }
  const auto reader = Read(DataPath("dem/SainteHelens.tif"));
  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputConnection(reader->GetOutputPort());
  Write(writer, "side/out.tif");
  EXPECT_EQ(FilesIn(folder), std::vector<std::string>{ "out.tif" });
}
