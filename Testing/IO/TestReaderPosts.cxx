// SPDX-License-Identifier: BSD-3-Clause
// The heights of the posts.
#include "IoTesting.h"

#include "vtkDEMReader.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>

using namespace skyline_test;

namespace
{

const std::vector<double> NorthUp{ 500000, 10, 0, 5100000, 0, -10 };

/// Tests run in parallel, so each has its own copy.
std::string UncompressedDem(const std::string& name)
{
  const std::string path = OutputPath(name);
  const std::string packed = "/vsigzip/" + DataPath("dem/SainteHelens.dem.gz");
  const CPLConfigOptionSetter quiet("CPL_VSIL_GZIP_WRITE_PROPERTIES", "NO", false);
  GByte* bytes = nullptr;
  vsi_l_offset size = 0;
  EXPECT_TRUE(VSIIngestFile(nullptr, packed.c_str(), &bytes, &size, -1));
  std::ofstream(path, std::ios::binary)
    .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  CPLFree(bytes);
  return path;
}

/// The heights and the missing posts are equal to the bit.
void ExpectSameHeights(vtkImageData* a, vtkImageData* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  vtkDataArray* first = a->GetPointData()->GetScalars();
  vtkDataArray* second = b->GetPointData()->GetScalars();
  vtkIdType different = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    const double x = first->GetComponent(i, 0);
    const double y = second->GetComponent(i, 0);
    different += !(x == y || (std::isnan(x) && std::isnan(y)));
  }
  EXPECT_EQ(different, 0);
}

} // namespace

TEST(ReaderPosts, RowZeroIsSouth)
{
  Recipe recipe;
  recipe.Transform = NorthUp;
  const auto image = ReadImage(recipe);
  EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "Elevation");
  EXPECT_EQ(image->GetDimensions()[0], 5);
  EXPECT_EQ(image->GetDimensions()[1], 4);
  EXPECT_EQ(image->GetDimensions()[2], 1);
  EXPECT_EQ(HeightAt(image, 0, 0), 30.0);
  EXPECT_EQ(HeightAt(image, 4, 3), 4.0);
}

// The four possible orders of lines and columns in a file give the same surface (swapped limits,
// negative pixel sizes).
TEST(ReaderPosts, TheFilesDirectionDoesNotMatter)
{
  Recipe recipe;
  recipe.Crs = "EPSG:32610";
  recipe.Transform = NorthUp;
  const auto plain = ReadImage(recipe);
  const skyline::Georeference place = skyline::LoadGeoreference(plain);
  for (const bool mirrored : { false, true })
  {
    for (const bool southUp : { false, true })
    {
      Recipe turned = recipe;
      turned.Transform = { mirrored ? 500050.0 : 500000.0, mirrored ? -10.0 : 10.0, 0,
        southUp ? 5099960.0 : 5100000.0, 0, southUp ? 10.0 : -10.0 };
      turned.Value = [=](int column, int line)
      { return recipe.Value(mirrored ? 4 - column : column, southUp ? 3 - line : line); };
      const auto image = ReadImage(turned);
      ExpectSameHeights(plain, image);
      EXPECT_EQ(skyline::LoadGeoreference(image).GeoTransform, place.GeoTransform);
      EXPECT_EQ(skyline::LoadGeoreference(image).Longitude, place.Longitude);
      EXPECT_EQ(image->GetOrigin()[0], 500005.0);
      EXPECT_EQ(image->GetOrigin()[1], 5099965.0);
    }
  }
}

// Coordinates of South African maps increase to the west and to the south, so their north-up files
// have negative pixel widths and positive pixel heights.
TEST(ReaderPosts, AxesToTheSouthWest)
{
  Recipe recipe;
  recipe.Crs = "EPSG:2053";
  recipe.Transform = { -50000, -10, 0, 3300000, 0, 10 };
  const auto image = ReadImage(recipe);
  EXPECT_EQ(HeightAt(image, 0, 0), 30.0);
  EXPECT_EQ(image->GetSpacing()[0], 10.0);
  const skyline::Georeference place = skyline::LoadGeoreference(image);
  EXPECT_GT(place.Longitude[1], place.Longitude[0]);
  EXPECT_GT(place.Latitude.back(), place.Latitude.front());
  EXPECT_NEAR(place.ConvergenceAt(2, 2), 0.0, 1.0); // near the map's central meridian, 29 E
}

TEST(ReaderPosts, BandsCountFromOne)
{
  Recipe recipe;
  recipe.Bands = 3;
  const std::string file = Make(recipe);
  EXPECT_EQ(HeightAt(Read(file)->GetOutput(), 0, 0), 30.0);
  EXPECT_EQ(HeightAt(Read(file, 3)->GetOutput(), 0, 0), 2030.0);
}

// Integers in metres are kept. Values that need NaN or fractions become float, or double where
// float has too few digits.
TEST(ReaderPosts, TypesStayAsNarrowAsTheyCan)
{
  struct Case
  {
    GDALDataType Type;
    int Plain, Converted;
  };
  for (const Case& types : { Case{ GDT_Byte, VTK_UNSIGNED_CHAR, VTK_FLOAT },
         Case{ GDT_Int16, VTK_SHORT, VTK_FLOAT }, Case{ GDT_UInt16, VTK_UNSIGNED_SHORT, VTK_FLOAT },
         Case{ GDT_Int32, VTK_INT, VTK_DOUBLE }, Case{ GDT_UInt32, VTK_UNSIGNED_INT, VTK_DOUBLE },
         Case{ GDT_Int64, VTK_LONG_LONG, VTK_DOUBLE },
         Case{ GDT_UInt64, VTK_UNSIGNED_LONG_LONG, VTK_DOUBLE },
         Case{ GDT_Float32, VTK_FLOAT, VTK_FLOAT }, Case{ GDT_Float64, VTK_DOUBLE, VTK_DOUBLE } })
  {
    Recipe recipe;
    recipe.Type = types.Type;
    EXPECT_EQ(ReadImage(recipe)->GetScalarType(), types.Plain);
    recipe.Scale = 0.5;
    recipe.Offset = -100.0;
    const auto scaled = ReadImage(recipe);
    EXPECT_EQ(scaled->GetScalarType(), types.Converted);
    EXPECT_EQ(HeightAt(scaled, 4, 0), -83.0); // 34 / 2 - 100
    Recipe withNodata;
    withNodata.Type = types.Type;
    withNodata.HasNodata = true;
    withNodata.Nodata = 12.0;
    const auto holed = ReadImage(withNodata);
    EXPECT_EQ(holed->GetScalarType(), types.Converted);
    EXPECT_TRUE(std::isnan(HeightAt(holed, 2, 2)));
    EXPECT_EQ(HeightAt(holed, 3, 2), 13.0);
  }
}

TEST(ReaderPosts, DoubleKeepsMillimetresOnHugeHeights)
{
  Recipe recipe;
  recipe.Type = GDT_Float64;
  recipe.Value = [](int column, int line) { return 1e7 + 0.001 * (column + 10 * line); };
  EXPECT_EQ(HeightAt(ReadImage(recipe), 4, 0), 1e7 + 0.034);
}

TEST(ReaderPosts, NodataNanAndInfinitiesAreMissing)
{
  Recipe recipe;
  recipe.HasNodata = true;
  recipe.Nodata = -9999.0;
  recipe.Value = [](int column, int)
  {
    const double values[] = { -9999.0, NaN, Infinity, -Infinity, 7.0 };
    return values[column];
  };
  const auto image = ReadImage(recipe);
  for (int column = 0; column < 4; ++column)
  {
    EXPECT_TRUE(std::isnan(HeightAt(image, column, 1))) << column;
  }
  EXPECT_EQ(HeightAt(image, 4, 1), 7.0);
  double nodata = 0.0;
  EXPECT_TRUE(skyline::LoadNodataValue(image, nodata));
  EXPECT_EQ(nodata, -9999.0);
}

// The lowest float, printed with six digits in a text header, still counts as that value.
TEST(ReaderPosts, RoundedLowestFloatIsNodata)
{
  const std::string path = OutputPath("lowest.asc");
  std::ofstream(path) << "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n"
                         "NODATA_value -3.40282e+38\n1.5 2.5\n-3.4028234663852886e+38 4.5\n";
  const auto reader = Read(path);
  EXPECT_TRUE(std::isnan(HeightAt(reader->GetOutput(), 0, 0)));
  EXPECT_EQ(HeightAt(reader->GetOutput(), 1, 0), 4.5);
  EXPECT_EQ(HeightAt(reader->GetOutput(), 0, 1), 1.5);
}

TEST(ReaderPosts, NodataComesBeforeScaleAndOffset)
{
  Recipe recipe;
  recipe.Type = GDT_Int16;
  recipe.HasNodata = true;
  recipe.Nodata = 12.0;
  recipe.Scale = 0.1;
  const auto image = ReadImage(recipe);
  EXPECT_TRUE(std::isnan(HeightAt(image, 2, 2)));
  EXPECT_FLOAT_EQ(static_cast<float>(HeightAt(image, 3, 2)), 1.3f);
}

TEST(ReaderPosts, MaskAndAlphaBandsHidePosts)
{
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  for (const bool alpha : { false, true })
  {
    CPLStringList options;
    options.SetNameValue("ALPHA", alpha ? "YES" : "NO");
    CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES");
    GDALDataset* dataset =
      driver->Create("/vsimem/mask.tif", 3, 2, alpha ? 2 : 1, GDT_Byte, options.List());
    unsigned char heights[6] = { 1, 2, 3, 4, 5, 6 };
    unsigned char shown[6] = { 255, 255, 0, 255, 255, 255 };
    ASSERT_EQ(dataset->GetRasterBand(1)->RasterIO(
                GF_Write, 0, 0, 3, 2, heights, 3, 2, GDT_Byte, 0, 0, nullptr),
      CE_None);
    if (!alpha)
    {
      ASSERT_EQ(dataset->CreateMaskBand(GMF_PER_DATASET), CE_None);
    }
    GDALRasterBand* mask =
      alpha ? dataset->GetRasterBand(2) : dataset->GetRasterBand(1)->GetMaskBand();
    ASSERT_EQ(mask->RasterIO(GF_Write, 0, 0, 3, 2, shown, 3, 2, GDT_Byte, 0, 0, nullptr), CE_None);
    GDALClose(dataset);
    CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", nullptr);

    const auto reader = Read("/vsimem/mask.tif");
    EXPECT_TRUE(std::isnan(HeightAt(reader->GetOutput(), 2, 1)));
    EXPECT_EQ(HeightAt(reader->GetOutput(), 1, 1), 2.0);
    EXPECT_EQ(HeightAt(reader->GetOutput(), 2, 0), 6.0);
  }
}

TEST(ReaderPosts, FeetBecomeMetres)
{
  struct Case
  {
    const char* Crs;
    const char* Unit;
    double Metres;
  };
  for (const Case& feet : { Case{ "", "ft", 0.3048 }, Case{ "", "US survey foot", 1200.0 / 3937.0 },
         Case{ "EPSG:26910+6360", "", 1200.0 / 3937.0 }, Case{ "EPSG:26910+8228", "", 0.3048 },
         Case{ "EPSG:26910+5703", "", 1.0 }, Case{ "EPSG:26910+6360", "m", 1.0 },
         Case{ "EPSG:2263", "", 1.0 } })
  {
    Recipe recipe;
    recipe.Type = GDT_Float64;
    recipe.Crs = feet.Crs;
    recipe.Unit = feet.Unit;
    recipe.Transform = NorthUp;
    EXPECT_DOUBLE_EQ(HeightAt(ReadImage(recipe), 4, 0), 34.0 * feet.Metres)
      << feet.Crs << " " << feet.Unit;
  }
}

TEST(ReaderPosts, AsksTheFileOnlyForTheExtent)
{
  // 40000 x 40000 posts in a million blocks, of which only the one in the corner exists.
  Recipe recipe;
  recipe.Columns = recipe.Lines = 40000;
  GDALAllRegister();
  CPLStringList options;
  options.SetNameValue("SPARSE_OK", "TRUE");
  options.SetNameValue("TILED", "YES");
  GDALDataset* dataset = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
    "/vsimem/huge.tif", 40000, 40000, 1, GDT_Float32, options.List());
  float corner[4] = { 1.0f, 2.0f, 3.0f, 4.0f };
  ASSERT_EQ(dataset->GetRasterBand(1)->RasterIO(
              GF_Write, 39998, 39998, 2, 2, corner, 2, 2, GDT_Float32, 0, 0, nullptr),
    CE_None);
  GDALClose(dataset);

  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName("/vsimem/huge.tif");
  const int extent[6] = { 39997, 39999, 0, 1, 0, 0 };
  reader->UpdateExtent(extent);
  int whole[6];
  reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  EXPECT_EQ(whole[1], 39999);
  EXPECT_EQ(whole[3], 39999);
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), 6);
  EXPECT_EQ(HeightAt(reader->GetOutput(), 39999, 0), 4.0);
  EXPECT_EQ(HeightAt(reader->GetOutput(), 39999, 1), 2.0);
  EXPECT_EQ(HeightAt(reader->GetOutput(), 39997, 1), 0.0);
  VSIUnlink("/vsimem/huge.tif");
}

TEST(ReaderPosts, AnExtentIsACrop)
{
  const std::string file = DataPath("dem/SainteHelens.tif");
  const auto whole = Read(file);
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(file.c_str());
  const int extent[6] = { 101, 140, 51, 110, 0, 0 };
  reader->UpdateExtent(extent);
  vtkImageData* part = reader->GetOutput();
  int delivered[6];
  part->GetExtent(delivered);
  EXPECT_TRUE(std::equal(extent, extent + 6, delivered));
  EXPECT_EQ(part->GetNumberOfPoints(), 40 * 60);
  for (int row = 51; row <= 110; ++row)
  {
    for (int column = 101; column <= 140; ++column)
    {
      ASSERT_EQ(HeightAt(part, column, row), HeightAt(whole->GetOutput(), column, row));
    }
  }

  const skyline::Georeference place = skyline::LoadGeoreference(part);
  EXPECT_EQ(place.Columns, 40);
  EXPECT_EQ(place.Rows, 60);
  // The north-western corner of the crop as GDAL defines it: of 468 rows, 468 - 111 lie above.
  EXPECT_EQ(place.GeoTransform[0], 557805.0 + 101 * 30.0);
  EXPECT_EQ(place.GeoTransform[3], 5122005.0 - 357 * 30.0);
  const skyline::Georeference all = skyline::LoadGeoreference(whole->GetOutput());
  double longitude = 0, latitude = 0, expectedLongitude = 0, expectedLatitude = 0;
  place.LonLatAt(7, 9, longitude, latitude);
  all.LonLatAt(108, 60, expectedLongitude, expectedLatitude);
  const double interpolation = 1e-9; // degrees; DefaultLatticeNodes has an error of 2 cm at 1000 km
  EXPECT_NEAR(longitude, expectedLongitude, interpolation);
  EXPECT_NEAR(latitude, expectedLatitude, interpolation);
}

// Tiles, strips and odd sizes, read in parts: each value encodes its own position, which is
// checked.
TEST(ReaderPosts, StripsAndTilesMeet)
{
  Recipe recipe;
  recipe.Columns = 1031;
  recipe.Lines = 2053; // several strips of 4 MiB
  recipe.Type = GDT_Float64;
  recipe.Value = [](int column, int line) { return column + 5000.0 * line; };
  GDALAllRegister();
  for (const char* tiled : { "YES", "NO" })
  {
    for (const double height : { 10.0, -10.0 })
    {
      CPLStringList options;
      options.SetNameValue("TILED", tiled);
      recipe.Transform = { 0, 10, 0, 0, 0, height };
      Fill(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
             "/vsimem/tiles.tif", 1031, 2053, 1, GDT_Float64, options.List()),
        recipe);
      const auto reader = Read("/vsimem/tiles.tif");
      int wrong = 0;
      for (int row = 0; row < 2053; ++row)
      {
        const int line = height > 0 ? row : 2052 - row;
        for (int column = 0; column < 1031; ++column)
        {
          wrong += HeightAt(reader->GetOutput(), column, row) != column + 5000.0 * line;
        }
      }
      EXPECT_EQ(wrong, 0) << tiled << " " << height;
    }
  }
  VSIUnlink("/vsimem/tiles.tif");
}

// The ASCII format of the USGS: the posts are those of the GeoTIFF that was made from it, also if
// the file is compressed with gzip.
TEST(ReaderPosts, UsgsDemIsItsGeoTiff)
{
  const auto tiff = Read(DataPath("dem/SainteHelens.tif"));
  for (const std::string& file :
    { UncompressedDem("same.dem"), "/vsigzip/" + DataPath("dem/SainteHelens.dem.gz") })
  {
    const auto dem = Read(file);
    ExpectSameHeights(tiff->GetOutput(), dem->GetOutput());
    for (int axis = 0; axis < 2; ++axis)
    {
      EXPECT_EQ(dem->GetOutput()->GetOrigin()[axis], tiff->GetOutput()->GetOrigin()[axis]);
      EXPECT_EQ(dem->GetOutput()->GetSpacing()[axis], 30.0);
    }
  }
}

TEST(ReaderPosts, GzipFilesGetNoPropertiesFile)
{
  const std::filesystem::path packed = OutputPath("notes.dem.gz");
  const std::filesystem::path note = packed.string() + ".properties";
  std::filesystem::remove(note);
  std::filesystem::copy_file(
    DataPath("dem/SainteHelens.dem.gz"), packed, std::filesystem::copy_options::overwrite_existing);
  EXPECT_GT(Read("/vsigzip/" + packed.string())->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_FALSE(std::filesystem::exists(note));
}

// VTK's reader of this format finds the same profiles. It puts the first post of each profile into
// row 0, although the file places it up to 4 rows higher, so that only the sequences are compared.
TEST(ReaderPosts, UsgsProfilesAreWhatVtkReads)
{
  const std::string file = UncompressedDem("profiles.dem");
  const auto ours = Read(file);
  vtkNew<vtkDEMReader> theirs;
  theirs->SetFileName(file.c_str());
  theirs->Update();
  vtkImageData* image = ours->GetOutput();
  vtkImageData* other = theirs->GetOutput();
  ASSERT_EQ(other->GetDimensions()[0], 327);
  const int rows = other->GetDimensions()[1];
  int compared = 0, different = 0;
  for (int column = 0; column < 327; ++column)
  {
    int first = 0;
    while (std::isnan(HeightAt(image, column, first)))
    {
      ++first;
    }
    for (int row = 0; row < rows && first + row < 468; ++row)
    {
      const double height = HeightAt(image, column, first + row);
      if (std::isfinite(height))
      {
        ++compared;
        different += height != other->GetScalarComponentAsDouble(column, row, 0, 0);
      }
    }
  }
  EXPECT_GT(compared, 148000);
  EXPECT_EQ(different, 0);
}

// A void-filled SRTM tile with 1201 posts per side: big-endian, with posts on the full degrees.
TEST(ReaderPosts, SrtmTile)
{
  const std::string path = OutputPath("S01W071.hgt");
  std::ofstream file(path, std::ios::binary);
  for (int line = 0; line < 1201; ++line)
  {
    for (int column = 0; column < 1201; ++column)
    {
      const auto height =
        static_cast<std::int16_t>(line == 0 && column == 0 ? -32768 : column - line);
      const auto bits = static_cast<std::uint16_t>(height);
      file.put(static_cast<char>(bits >> 8)).put(static_cast<char>(bits & 255));
    }
  }
  file.close();
  const auto reader = Read(path);
  vtkImageData* image = reader->GetOutput();
  EXPECT_TRUE(std::isnan(HeightAt(image, 0, 1200)));
  EXPECT_EQ(HeightAt(image, 7, 1200 - 100), -93.0);
  double longitude = 0.0, latitude = 0.0;
  skyline::LoadGeoreference(image).LonLatAt(1200, 0, longitude, latitude);
  EXPECT_NEAR(longitude, -70.0, 1e-9); // degrees; 0.1 mm
  EXPECT_NEAR(latitude, -1.0, 1e-9);
}

TEST(ReaderPosts, ProgressRisesAndAbortLeavesNothing)
{
  Recipe recipe;
  recipe.Columns = 1024;
  recipe.Lines = 4096; // 16 MiB, four strips
  const std::string file = Make(recipe);
  std::vector<double> seen;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&seen);
  watch->SetCallback(
    [](vtkObject* reader, unsigned long, void* list, void*)
    {
      auto* values = static_cast<std::vector<double>*>(list);
      values->push_back(vtkAlgorithm::SafeDownCast(reader)->GetProgress());
    });
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(file.c_str());
  reader->AddObserver(vtkCommand::ProgressEvent, watch);
  reader->Update();
  EXPECT_GE(seen.size(), 4u);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);

  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* object, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(object)->SetAbortExecute(1); });
  reader->AddObserver(vtkCommand::ProgressEvent, stop);
  const Errors errors(reader);
  seen.clear();
  reader->Modified();
  reader->Update();
  EXPECT_EQ(errors.Count(), 0u);
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::UserError);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_LT(seen.size(), 4u);
  VSIUnlink(file.c_str());
}
