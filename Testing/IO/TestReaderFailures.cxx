// SPDX-License-Identifier: BSD-3-Clause
// Each bad input leads to one line that names the file, the value and what to do.
#include "IoTesting.h"

#include <fstream>

using namespace skyline_test;

namespace
{

struct Failure
{
  std::string Message;
  unsigned long Code = 0;
};

Failure Fail(const std::string& file, int band = 1)
{
  vtkNew<vtkHeightFieldReader> reader;
  const Errors errors(reader);
  reader->SetFileName(file.c_str());
  reader->SetBand(band);
  reader->Update();
  EXPECT_EQ(errors.Count(), 1u) << file;
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << file;
  const std::string message = errors.First();
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_TRUE(file.empty() || message.find("'" + file + "'") != std::string::npos) << message;
  EXPECT_NE(message.find(';'), std::string::npos) << "no cure: " << message;
  return { message, reader->GetErrorCode() };
}

void ExpectFailure(const std::string& file, unsigned long code, const std::string& words)
{
  const Failure failure = Fail(file);
  EXPECT_EQ(failure.Code, code) << failure.Message;
  EXPECT_NE(failure.Message.find(words), std::string::npos) << failure.Message;
}

void ExpectRefusal(const Recipe& recipe, const std::string& words)
{
  ExpectFailure(Make(recipe), vtkErrorCode::FileFormatError, words);
}

/// Makes a VRT of a raster, with the given elements before the band.
std::string Wrap(const std::string& elements)
{
  Make(Recipe(), "/vsimem/wrapped.tif");
  const std::string text = "<VRTDataset rasterXSize='5' rasterYSize='4'>" + elements +
    "<VRTRasterBand dataType='Float32' band='1'><SimpleSource>"
    "<SourceFilename>/vsimem/wrapped.tif</SourceFilename><SourceBand>1</SourceBand>"
    "</SimpleSource></VRTRasterBand></VRTDataset>";
  VSILFILE* file = VSIFOpenL("/vsimem/wrap.vrt", "wb");
  VSIFWriteL(text.data(), 1, text.size(), file);
  VSIFCloseL(file);
  return "/vsimem/wrap.vrt";
}

} // namespace

TEST(ReaderFailures, ClassicNetcdfThatCountsTooMuch)
{
  const auto put = [](const char* name, char variables, char most)
  {
    const std::string file = ::testing::TempDir() + name;
    // No records, dimensions or attributes, then variables, whose number stands in the first and
    // last byte.
    const char header[] = { 'C', 'D', 'F', 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
      0, 0, 0, 0, 0, 11, most, 0, 0, variables };
    std::ofstream(file, std::ios::binary).write(header, sizeof(header));
    return file;
  };
  const std::string words = "its netCDF header declares more data than the file holds";
  EXPECT_NE(Fail(put("many.nc", 0, 16)).Message.find(words), std::string::npos);
  EXPECT_NE(Fail(put("one.nc", 1, 0)).Message.find(words), std::string::npos);
  EXPECT_EQ(Fail(put("none.nc", 0, 0)).Message.find(words), std::string::npos);
}

TEST(ReaderFailures, NoFileName)
{
  ExpectFailure("", vtkErrorCode::NoFileNameError, "SetFileName");
}

TEST(ReaderFailures, MissingFile)
{
  ExpectFailure(OutputPath("absent.tif"), vtkErrorCode::FileNotFoundError, "No such file");
}

TEST(ReaderFailures, NotARaster)
{
  const std::string path = OutputPath("notes.txt");
  std::ofstream(path) << "these are no heights\n";
  ExpectFailure(path, vtkErrorCode::UnrecognizedFileTypeError, "not recognized");
  ExpectFailure(SKYLINE_TEST_OUTPUT, vtkErrorCode::UnrecognizedFileTypeError, "cannot read");
}

TEST(ReaderFailures, EmptyAndTruncatedFiles)
{
  const std::string path = OutputPath("empty.tif");
  std::ofstream(path) << "";
  ExpectFailure(path, vtkErrorCode::UnrecognizedFileTypeError, "cannot read");

  Recipe recipe;
  recipe.Columns = recipe.Lines = 300;
  const std::string cut = Make(recipe, OutputPath("cut.tif"));
  std::filesystem::resize_file(cut, std::filesystem::file_size(cut) / 2);
  ExpectFailure(cut, vtkErrorCode::PrematureEndOfFileError, "cannot read row");
}

TEST(ReaderFailures, NoSuchBand)
{
  Recipe recipe;
  recipe.Bands = 3;
  const std::string file = Make(recipe);
  for (const int band : { 0, 4, -1, 1000000000 })
  {
    const std::string message = Fail(file, band).Message;
    EXPECT_NE(message.find("no band " + std::to_string(band)), std::string::npos) << message;
    EXPECT_NE(message.find("from 1 to 3"), std::string::npos) << message;
  }
}

TEST(ReaderFailures, NoSurface)
{
  for (const auto& size : { std::pair<int, int>{ 1, 1 }, { 1, 9 }, { 9, 1 } })
  {
    Recipe recipe;
    recipe.Columns = size.first;
    recipe.Lines = size.second;
    ExpectRefusal(recipe, "no surface");
  }
}

TEST(ReaderFailures, AllMissing)
{
  Recipe recipe;
  recipe.HasNodata = true;
  recipe.Nodata = -9999.0;
  recipe.Value = [](int, int) { return -9999.0; };
  ExpectRefusal(recipe, "missing");
  recipe.HasNodata = false;
  recipe.Value = [](int, int) { return NaN; };
  ExpectRefusal(recipe, "missing");
}

// A part without heights is no error if the whole has some.
TEST(ReaderFailures, APartMayBeAllMissing)
{
  Recipe recipe;
  recipe.Value = [](int column, int) { return column < 3 ? NaN : 1.0; };
  const std::string file = Make(recipe);
  vtkNew<vtkHeightFieldReader> reader;
  const Errors errors(reader);
  reader->SetFileName(file.c_str());
  const int extent[6] = { 0, 1, 0, 3, 0, 0 };
  reader->UpdateExtent(extent);
  EXPECT_EQ(errors.Count(), 0u);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 8);
}

TEST(ReaderFailures, RotatedAndSheared)
{
  Recipe recipe;
  for (const std::vector<double>& transform :
    { std::vector<double>{ 0, 10, 3, 0, 3, -10 }, { 0, 10, 3, 0, 0, -10 }, { 0, 0, 10, 0, 10, 0 } })
  {
    recipe.Transform = transform;
    ExpectRefusal(recipe, "rotated or sheared");
  }
  // A rounding error of a program that multiplied by a cosine does not count as a rotation.
  recipe.Transform = { 0, 10, 1e-12, 0, 1e-12, -10 };
  EXPECT_EQ(HeightAt(ReadImage(recipe), 0, 0), 30.0);
}

TEST(ReaderFailures, NoPixelSize)
{
  Recipe recipe;
  recipe.Transform = { 0, 10, 0, 0, 0, NaN };
  ExpectFailure(Wrap("<GeoTransform>0, 10, 0, 0, 0, 0</GeoTransform>"),
    vtkErrorCode::FileFormatError, "no size");
}

TEST(ReaderFailures, UnitUnknown)
{
  const std::string transform = "<GeoTransform>0, 10, 0, 0, 0, -10</GeoTransform>";
  for (const char* crs : { "LOCAL_CS[\"hall\",UNIT[\"unknown\",1]]",
         "LOCAL_CS[\"hall\",UNIT[\"metre\",0]]", "LOCAL_CS[\"hall\",UNIT[\"unitless\",1]]",
         "ENGCRS[\"hall\",EDATUM[\"floor\"],CS[Cartesian,2],AXIS[\"x\",east,ORDER[1]],"
         "AXIS[\"y\",north,ORDER[2]],LENGTHUNIT[\"unknown\",1]]" })
  {
    ExpectFailure(Wrap("<SRS>" + std::string(crs) + "</SRS>" + transform),
      vtkErrorCode::FileFormatError, "whose length is not known");
  }
  const auto metres = Read(Wrap("<SRS>LOCAL_CS[\"hall\",UNIT[\"foot\",0.3048]]</SRS>" + transform));
  EXPECT_DOUBLE_EQ(metres->GetOutput()->GetSpacing()[0], 3.048);

  Recipe recipe;
  recipe.Unit = "degC";
  ExpectRefusal(recipe, "'degC'");
}

TEST(ReaderFailures, OtherKindsOfCrs)
{
  const std::string transform = "<GeoTransform>0, 10, 0, 0, 0, -10</GeoTransform>";
  ExpectFailure(Wrap("<SRS>EPSG:4978</SRS>" + transform), vtkErrorCode::FileFormatError,
    "neither geographic nor projected");
  ExpectFailure(Wrap("<SRS>IAU_2015:49901</SRS>" + transform), vtkErrorCode::FileFormatError,
    "grow to the west");
}

TEST(ReaderFailures, NoPlaceOnTheBody)
{
  Recipe recipe;
  recipe.Crs = "EPSG:4326";
  recipe.Transform = { 0, 10, 0, 500, 0, -10 };
  ExpectRefusal(recipe, "has no longitude and latitude");
  recipe.Crs = "+proj=ortho +lat_0=0 +lon_0=0 +R=1737400 +type=crs";
  recipe.Transform = { -2000000, 800000, 0, 2000000, 0, -1000000 };
  ExpectRefusal(recipe, "has no longitude and latitude");
}

// Goode's map is interrupted at 40 degrees west in the northern hemisphere and at 20 degrees west
// in the southern.
TEST(ReaderFailures, TornMap)
{
  Recipe recipe;
  recipe.Crs = "+proj=igh +datum=WGS84 +units=m +type=crs";
  recipe.Transform = { -2900000, 10000, 0, -40000, 0, -10000 };
  recipe.Columns = 120;
  recipe.Lines = 30;
  ExpectRefusal(recipe, "cut the raster to");
}

TEST(ReaderFailures, CrsWithoutCorners)
{
  Recipe recipe;
  recipe.Crs = "EPSG:32610";
  ExpectRefusal(recipe, "no geotransform");
}

TEST(ReaderFailures, GroundControlPoints)
{
  ExpectFailure(Wrap("<GCPList Projection='EPSG:4326'>"
                     "<GCP Id='1' Pixel='0' Line='0' X='10' Y='50' Z='0'/>"
                     "<GCP Id='2' Pixel='5' Line='0' X='11' Y='50' Z='0'/>"
                     "<GCP Id='3' Pixel='0' Line='4' X='10' Y='49' Z='0'/></GCPList>"),
    vtkErrorCode::FileFormatError, "control points");
}

TEST(ReaderFailures, ComplexNumbers)
{
  Recipe recipe;
  recipe.Type = GDT_CFloat32;
  ExpectRefusal(recipe, "CFloat32");
}

TEST(ReaderFailures, SubdatasetsAreNamed)
{
  // A GeoPackage with two rasters has no band that can be read directly.
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  if (!driver)
  {
    GTEST_SKIP() << "this GDAL has no GeoPackage";
  }
  const std::string file = OutputPath("two.gpkg");
  std::filesystem::remove(file);
  for (const char* table : { "first", "second" })
  {
    CPLStringList options;
    options.SetNameValue("RASTER_TABLE", table);
    options.SetNameValue("APPEND_SUBDATASET", "YES");
    Recipe recipe;
    recipe.Crs = "EPSG:32610";
    recipe.Transform = { 500000, 10, 0, 5100000, 0, -10 };
    Fill(driver->Create(file.c_str(), 5, 4, 1, GDT_Byte, options.List()), recipe);
  }
  ExpectFailure(
    file, vtkErrorCode::FileFormatError, "it holds 2 rasters; name one, such as 'GPKG:");
}

// A reader that failed works again when its file has been corrected.
TEST(ReaderFailures, Recovers)
{
  vtkNew<vtkHeightFieldReader> reader;
  const Errors errors(reader);
  reader->SetFileName(OutputPath("absent.tif").c_str());
  reader->Update();
  EXPECT_NE(reader->GetErrorCode(), vtkErrorCode::NoError);
  reader->SetFileName(Make(Recipe()).c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 20);
}
