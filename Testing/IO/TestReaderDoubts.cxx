// SPDX-License-Identifier: BSD-3-Clause
// Cases in which the reader warns, and cases in which it must not.
#include "IoTesting.h"

#include "vtkFloatArray.h"

using namespace skyline_test;

namespace
{

const std::vector<double> Place{ 500000, 30, 0, 4200000, 0, -30 };

/// The warnings of a reader, one per line, without the text that VTK adds.
std::string WarningsOf(vtkHeightFieldReader* reader)
{
  std::string text;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetClientData(&text);
  keep->SetCallback(
    [](vtkObject*, unsigned long, void* client, void* data)
    {
      const std::string said = static_cast<const char*>(data);
      const std::size_t begin = said.find("): ");
      *static_cast<std::string*>(client) += said.substr(begin == std::string::npos ? 0 : begin + 3);
    });
  reader->AddObserver(vtkCommand::WarningEvent, keep);
  const Errors errors(reader);
  reader->Update();
  reader->RemoveObserver(keep);
  EXPECT_EQ(errors.First(), "");
  return text;
}

std::string WarningsOf(const std::string& file, const std::vector<double>& nodata = {})
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(file.c_str());
  for (const double value : nodata)
  {
    reader->AddNodata(value);
  }
  return WarningsOf(reader);
}

double Hill(int column, int line)
{
  return 1000.0 + 300.0 * std::sin(0.7 * column) * std::cos(0.9 * line);
}

/// Hills of 20 x 20 posts, of which `posts` have the value `value`.
Recipe HillsWith(double value, int posts, GDALDataType type = GDT_Float32)
{
  Recipe recipe;
  recipe.Columns = recipe.Lines = 20;
  recipe.Type = type;
  recipe.Crs = "EPSG:32610";
  recipe.Transform = Place;
  recipe.Value = [=](int column, int line)
  { return line * 20 + column < posts ? value : Hill(column, line); };
  return recipe;
}

void Expect(const std::string& warnings, const std::string& words)
{
  EXPECT_NE(warnings.find(words), std::string::npos) << words << " is not in: " << warnings;
}

} // namespace

TEST(ReaderDoubts, FillValuesAreNamedCountedAndCured)
{
  for (const double fill :
    { -9999.0, -99999.0, -32767.0, -32768.0, 32767.0, 0.0, -1e6, 1e20, -9998.0, -5000.0, -2000.0 })
  {
    for (const int posts : { 1, 37 })
    {
      const std::string file = Make(HillsWith(fill, posts));
      const std::string warnings = WarningsOf(file);
      const std::string count = posts == 1 ? "1 post of '" : "37 posts of '";
      Expect(warnings, count + file + "' ha");
      const std::size_t cure = warnings.find("--nodata ");
      ASSERT_NE(cure, std::string::npos) << warnings;
      EXPECT_EQ(std::stod(warnings.substr(cure + 9)), fill) << warnings;
      EXPECT_EQ(WarningsOf(file, { fill }), "") << "the suggested option removes the warning";
    }
  }
  for (const GDALDataType type : { GDT_Int16, GDT_Int32, GDT_Float64 })
  {
    Expect(WarningsOf(Make(HillsWith(-32768.0, 5, type))), "5 posts of");
  }
}

TEST(ReaderDoubts, ZeroUnderAFlatTerrain)
{
  Recipe recipe = HillsWith(0.0, 16);
  recipe.Value = [](int i, int j)
  { return i < 4 && j < 4 ? 0.0 : 35.0 + 2.0 * std::sin(0.7 * i + j); };
  Expect(WarningsOf(Make(recipe)), "16 posts of '/vsimem/made.tif' have the height 0");
}

TEST(ReaderDoubts, DigitsAreThoseOfTheBand)
{
  const auto fill = static_cast<double>(9.969209968386869e36f);
  const std::string file = Make(HillsWith(fill, 3));
  Expect(WarningsOf(file), "--nodata 9.96921e+36");
  EXPECT_EQ(WarningsOf(file, { 9.96921e36 }), "");
  const std::string wide = Make(HillsWith(fill, 3, GDT_Float64));
  Expect(WarningsOf(wide), "--nodata 9.969209968386869e+36");
  EXPECT_EQ(WarningsOf(wide, { 9.969209968386869e36 }), "");
}

TEST(ReaderDoubts, TerrainIsNotDoubted)
{
  const auto quiet = [](const char* name, const std::function<double(int, int)>& value,
                       GDALDataType type = GDT_Float32)
  {
    Recipe recipe = HillsWith(0.0, 0, type);
    recipe.Columns = 100;
    recipe.Lines = 120;
    recipe.Value = value;
    EXPECT_EQ(WarningsOf(Make(recipe)), "") << name;
  };
  quiet("hills", Hill);
  quiet("a coast", [](int i, int j) { return std::max(0.0, std::round(20.0 * i - 10.0 * j)); });
  quiet(
    "bathymetry", [](int i, int j) { return -10900.0 + i * 109.0 + j; }, GDT_Int16);
  quiet("an abyss whose lowest post is -9999", [](int i, int j) { return -9999.0 + i + j; });
  quiet("below the sea", [](int i, int j) { return -430.0 + 0.1 * i + 0.1 * j; });
  quiet("towers on a plain", [](int i, int j) { return i == 50 && j % 3 == 0 ? 100.0 : 0.0; });
  quiet("a mountain of Mars", [](int i, int j) { return 21229.0 - 2.0 * std::hypot(i - 50.0, j); });
  quiet(
    "heights of 1e7 m", [](int i, int j) { return 1e7 + 0.001 * (i + j); }, GDT_Float64);
  quiet("houses above their ground",
    [](int i, int j) { return i > 50 && j % 3 == 0 ? 20.0 + 0.1 * j : 0.0; });
  quiet(
    "an island's shelf", [](int i, int j) { return i < 50 ? -4000.0 + 90.0 * i + j : 100.0 + i; });
  quiet("flat", [](int, int) { return 0.0; });
}

TEST(ReaderDoubts, ReliefOfNoBody)
{
  Recipe recipe = HillsWith(0.0, 0, GDT_Int32);
  recipe.Value = [](int i, int j) { return 15000.0 * (i + j); }; // millimetres
  Expect(WarningsOf(Make(recipe)),
    "reach from 0 to 570000 m, more than any body has; assuming they "
    "are heights in metres; use another unit");
  recipe.Unit = "mm";
  EXPECT_EQ(WarningsOf(Make(recipe)), "");
}

TEST(ReaderDoubts, FillAmongHeights)
{
  Recipe recipe = HillsWith(0.0, 0, GDT_Int16);
  recipe.Columns = 100;
  recipe.Lines = 120;
  recipe.Value = [](int i, int j) { return j < 5 ? -9999.0 : -10900.0 + i * 109.0 + j; };
  Expect(WarningsOf(Make(recipe)), "posts of '/vsimem/made.tif' have the height -9999");
}

TEST(ReaderDoubts, MissingPostsAreNotCounted)
{
  Recipe recipe = HillsWith(-9999.0, 37);
  recipe.HasNodata = true;
  recipe.Nodata = -9999.0;
  EXPECT_EQ(WarningsOf(Make(recipe)), "");
  recipe.Nodata = 5.0;
  Expect(WarningsOf(Make(recipe)), "37 posts");
}

TEST(ReaderDoubts, NodataIsDeclaredByTheUser)
{
  for (const GDALDataType type : { GDT_Int16, GDT_Int32, GDT_Float32, GDT_Float64 })
  {
    vtkNew<vtkHeightFieldReader> reader;
    Recipe recipe = HillsWith(-9999.0, 37, type);
    recipe.HasNodata = true;
    recipe.Nodata = std::round(Hill(19, 19));
    const auto value = recipe.Value;
    recipe.Value = [=](int i, int j) { return i == 19 && j == 19 ? recipe.Nodata : value(i, j); };
    reader->SetFileName(Make(recipe).c_str());
    reader->AddNodata(-9999.0);
    reader->AddNodata(NaN);
    reader->AddNodata(-Infinity);
    EXPECT_EQ(reader->GetNumberOfNodata(), 3);
    EXPECT_EQ(reader->GetNodata(0), -9999.0);
    WarningsOf(reader);
    vtkImageData* image = reader->GetOutput();
    EXPECT_TRUE(std::isnan(HeightAt(image, 0, 19)));
    EXPECT_TRUE(std::isnan(HeightAt(image, 19, 0))) << "the file's own stays missing";
    EXPECT_FALSE(std::isnan(HeightAt(image, 19, 10)));
    reader->RemoveAllNodata();
    WarningsOf(reader);
    EXPECT_EQ(HeightAt(reader->GetOutput(), 0, 19), -9999.0);
  }
}

TEST(ReaderDoubts, NodataThatNoPostHas)
{
  Expect(WarningsOf(Make(HillsWith(0.0, 0)), { -9999.0 }),
    "no post of '/vsimem/made.tif' has the "
    "nodata value -9999; assuming");
}

TEST(ReaderDoubts, InfiniteNodataLeavesTheHeights)
{
  for (const double nodata : { Infinity, -Infinity, NaN })
  {
    Recipe recipe = HillsWith(nodata, 37);
    recipe.HasNodata = true;
    recipe.Nodata = nodata;
    vtkNew<vtkHeightFieldReader> reader;
    reader->SetFileName(Make(recipe).c_str());
    EXPECT_EQ(WarningsOf(reader), "");
    EXPECT_TRUE(std::isnan(HeightAt(reader->GetOutput(), 0, 19)));
    EXPECT_NEAR(HeightAt(reader->GetOutput(), 10, 0), Hill(10, 19), 1e-3);
  }
}

TEST(ReaderDoubts, NoGeotransform)
{
  Expect(WarningsOf(Make(Recipe())),
    "has no geotransform; assuming posts 1 m apart; use "
    "gdal_edit.py -a_ullr to say otherwise");
}

TEST(ReaderDoubts, DegreesWithoutCrs)
{
  Recipe recipe = HillsWith(0.0, 0);
  recipe.Crs = "";
  recipe.Transform = { 7.5, 1.0 / 1200.0, 0, 46.5, 0, -1.0 / 1200.0 };
  const std::string warnings = WarningsOf(Make(recipe));
  Expect(warnings, "has no CRS and looks like degrees (x 7.5 to 7.51667");
  Expect(warnings, "assuming x and y in metres; use gdal_edit.py -a_srs EPSG:4326 to say");
  recipe.Transform = { 0, 30, 0, 80, 0, -30 };
  EXPECT_EQ(WarningsOf(Make(recipe)), "") << "metres from a corner";
}

// A single absurd height must not count as the relief of the map.
TEST(ReaderDoubts, FillValuesMakeNoDegrees)
{
  Recipe recipe = HillsWith(-9999.0, 4);
  recipe.Crs = "";
  recipe.Transform = { 0, 4, 0, 80, 0, -4 };
  EXPECT_EQ(WarningsOf(Make(recipe)).find("degrees"), std::string::npos);
}

TEST(ReaderDoubts, HeightsOfAMapInFeet)
{
  Recipe recipe = HillsWith(0.0, 0);
  recipe.Crs = "EPSG:2263";
  recipe.Transform = { 1e6, 100, 0, 2e5, 0, -100 };
  Expect(WarningsOf(Make(recipe)),
    "is in units of 0.3048006096 m, and the unit of its heights is not "
    "given; assuming heights in metres");
  recipe.Unit = "m";
  EXPECT_EQ(WarningsOf(Make(recipe)), "");
}

// The vertical axis of a three-dimensional CRS, projected or geographic.
TEST(ReaderDoubts, HeightsInFeetOfThreeDimensions)
{
  for (const char* name : { "EPSG:32610", "EPSG:4326" })
  {
    OGRSpatialReference crs = CrsFrom(name);
    ASSERT_EQ(crs.PromoteTo3D(nullptr), OGRERR_NONE);
    const char* const options[] = { "FORMAT=WKT2_2019", nullptr };
    char* text = nullptr;
    crs.exportToWkt(&text, options);
    std::string wkt = text;
    CPLFree(text);
    const std::size_t axis = wkt.find("ellipsoidal height");
    const std::size_t unit = wkt.find("LENGTHUNIT[\"metre\",1", axis);
    ASSERT_NE(unit, std::string::npos) << wkt;
    const std::size_t end = wkt.find("]]", unit); // the unit may contain an identifier
    const bool identified = wkt.substr(unit, end - unit).find("ID[") != std::string::npos;
    wkt.replace(unit, end + (identified ? 2 : 1) - unit, "LENGTHUNIT[\"foot\",0.3048]");
    GDALAllRegister();
    Recipe recipe = HillsWith(0.0, 0);
    recipe.Crs = wkt;
    if (name == std::string("EPSG:4326"))
    {
      recipe.Transform = { -120, 0.001, 0, 40, 0, -0.001 };
    }
    // In memory, because older libraries do not store the third axis in a GeoTIFF.
    GDALDataset* dataset = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      "/vsimem/posts.tif", 20, 20, 1, GDT_Float32, nullptr);
    Recipe bare = HillsWith(0.0, 0);
    bare.Crs = "";
    Fill(dataset, bare);
    auto* source = GDALDataset::Open("/vsimem/posts.tif", GDAL_OF_RASTER);
    GDALDataset* copy = GetGDALDriverManager()->GetDriverByName("VRT")->CreateCopy(
      "/vsimem/three.vrt", source, FALSE, nullptr, nullptr, nullptr);
    const OGRSpatialReference three = CrsFrom(wkt);
    copy->SetSpatialRef(&three);
    copy->SetGeoTransform(recipe.Transform.data());
    GDALClose(copy);
    GDALClose(source);
    vtkNew<vtkHeightFieldReader> reader;
    reader->SetFileName("/vsimem/three.vrt");
    EXPECT_EQ(WarningsOf(reader), "");
    EXPECT_NEAR(HeightAt(reader->GetOutput(), 10, 0), 0.3048 * Hill(10, 19), 1e-3) << name;
  }
}

TEST(ReaderDoubts, UnitsThatContradict)
{
  Recipe recipe = HillsWith(0.0, 0);
  recipe.Crs = "EPSG:32610+6360"; // NAVD88 height (ftUS)
  recipe.Unit = "m";
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(Make(recipe).c_str());
  Expect(WarningsOf(reader),
    "are in 'm' according to the band, but in units of 0.3048006096 m "
    "according to the CRS; assuming the band's unit");
  EXPECT_NEAR(HeightAt(reader->GetOutput(), 10, 0), Hill(10, 19), 1e-3);
  recipe.Unit = "US survey foot";
  EXPECT_EQ(WarningsOf(Make(recipe)), "");
}

TEST(ReaderDoubts, Depths)
{
  Recipe recipe = HillsWith(0.0, 0);
  recipe.Crs = "EPSG:32610+5715"; // MSL depth
  Expect(WarningsOf(Make(recipe)),
    "the CRS of '/vsimem/made.tif' says that its values are depths; "
    "assuming heights that count upwards; use gdal_edit.py -scale -1");
  recipe.Scale = -1.0;
  EXPECT_EQ(WarningsOf(Make(recipe)), "");
}

TEST(ReaderDoubts, MetadataOfTheBand)
{
  const auto withItem = [](const char* key, const char* value)
  {
    const std::string file = Make(HillsWith(0.0, 0));
    GDALDataset* raster = GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE);
    raster->GetRasterBand(1)->SetMetadataItem(key, value);
    GDALClose(raster);
    return file;
  };
  Expect(WarningsOf(withItem("positive", "down")), "the item 'positive' of");
  Expect(WarningsOf(withItem("standard_name", "sea_floor_depth_below_geoid")), "the standard name");
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(withItem("units", "feet").c_str());
  EXPECT_EQ(WarningsOf(reader), "");
  EXPECT_NEAR(HeightAt(reader->GetOutput(), 10, 0), 0.3048 * Hill(10, 19), 1e-3);
}

TEST(ReaderDoubts, Pictures)
{
  Recipe recipe = HillsWith(0.0, 0, GDT_Byte);
  recipe.Bands = 3;
  recipe.Value = [](int i, int j) { return 5.0 * i + j; };
  Expect(WarningsOf(Make(recipe)),
    "band 1 of '/vsimem/made.tif' is the red part of a picture; "
    "assuming its values are heights\n");
}

// Warnings are raised once per execution, and not if only information is requested.
TEST(ReaderDoubts, AreRaisedOnce)
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(Make(HillsWith(-9999.0, 5)).c_str());
  int count = 0;
  vtkNew<vtkCallbackCommand> counting;
  counting->SetClientData(&count);
  counting->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { ++*static_cast<int*>(client); });
  reader->AddObserver(vtkCommand::WarningEvent, counting);
  reader->UpdateInformation();
  EXPECT_EQ(count, 0);
  reader->Update();
  reader->Update();
  EXPECT_EQ(count, 1);
}
