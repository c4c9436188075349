// SPDX-License-Identifier: BSD-3-Clause
// The positions of the posts: spacing, bodies, longitudes, convergence.
#include "IoTesting.h"

#include "Shared/Constants.h"

#include <algorithm>

using namespace skyline_test;
using skyline::Georeference;
using skyline::RadiansPerDegree;

namespace
{

/// Relative. Row spacings are measured over a pixel by geodesics with errors of nanometres, and a
/// chord of a parallel is shorter than the parallel by (pixel / 24 radius)^2.
constexpr double SpacingTolerance = 1e-6;

vtkSmartPointer<vtkImageData> ReadAt(
  const std::string& crs, const std::vector<double>& transform, int columns = 5, int lines = 5)
{
  Recipe recipe;
  recipe.Crs = crs;
  recipe.Transform = transform;
  recipe.Columns = columns;
  recipe.Lines = lines;
  return ReadImage(recipe);
}

void ExpectRelative(double value, double expected, double tolerance)
{
  EXPECT_NEAR(value, expected, tolerance * std::abs(expected));
}

/// Metres between two meridians that are one radian apart: N cos(latitude).
double ParallelRadius(const Georeference& place, double latitude)
{
  const double phi = latitude * RadiansPerDegree;
  const double e2 = place.Flattening * (2.0 - place.Flattening);
  return place.EquatorialRadius * std::cos(phi) /
    std::sqrt(1.0 - e2 * std::sin(phi) * std::sin(phi));
}

} // namespace

TEST(ReaderPlace, NoCrsIsMetres)
{
  const auto bare = ReadImage(Recipe());
  const Georeference nothing = skyline::LoadGeoreference(bare);
  EXPECT_TRUE(nothing.Crs.empty());
  EXPECT_FALSE(nothing.HasGeoTransform);
  EXPECT_FALSE(nothing.OnBody());
  EXPECT_EQ(bare->GetSpacing()[0], 1.0);
  EXPECT_EQ(bare->GetOrigin()[0], 0.0);
  EXPECT_EQ(HeightAt(bare, 0, 0), 30.0); // the first line is the northernmost

  const auto stretched = ReadAt("", { 100, 2.5, 0, 200, 0, -4 });
  EXPECT_EQ(stretched->GetSpacing()[0], 2.5);
  EXPECT_EQ(stretched->GetSpacing()[1], 4.0);
  EXPECT_EQ(stretched->GetOrigin()[0], 101.25);
  EXPECT_EQ(stretched->GetOrigin()[1], 182.0);
  EXPECT_TRUE(skyline::LoadGeoreference(stretched).HasGeoTransform);
}

TEST(ReaderPlace, UtmKeepsItsNominalSpacing)
{
  const auto image = ReadAt("EPSG:26710", { 557805, 30, 0, 5122005, 0, -30 });
  const Georeference place = skyline::LoadGeoreference(image);
  EXPECT_EQ(image->GetSpacing()[0], 30.0);
  EXPECT_EQ(image->GetSpacing()[1], 30.0);
  EXPECT_TRUE(place.RowSpacingX.empty());
  EXPECT_TRUE(place.Earth);
  EXPECT_EQ(place.EquatorialRadius, 6378206.4); // Clarke 1866
  EXPECT_NEAR(1.0 / place.Flattening, 294.978698213898, 1e-9);
  EXPECT_EQ(place.GeoTransform, (std::array<double, 6>{ { 557805, 30, 0, 5122005, 0, -30 } }));
}

// Pixels of a survey are not always square.
TEST(ReaderPlace, PixelsThatAreNotSquare)
{
  const auto image = ReadAt("EPSG:25830", { 499400, 2.502057979, 0, 4797200, 0, -2.502408883 });
  EXPECT_EQ(image->GetSpacing()[0], 2.502057979);
  EXPECT_EQ(image->GetSpacing()[1], 2.502408883);
}

TEST(ReaderPlace, SurveyFeetOnTheMap)
{
  const auto image = ReadAt("EPSG:2263", { 980000, 10, 0, 200000, 0, -10 });
  const double foot = 1200.0 / 3937.0;
  EXPECT_DOUBLE_EQ(image->GetSpacing()[0], 10 * foot);
  EXPECT_DOUBLE_EQ(image->GetOrigin()[0], 980005 * foot);
  EXPECT_DOUBLE_EQ(image->GetOrigin()[1], 199955 * foot);
  // The georeference keeps the geotransform of the file.
  EXPECT_EQ(skyline::LoadGeoreference(image).GeoTransform[0], 980000.0);
}

// Web Mercator at 49 degrees: a pixel is two thirds of its nominal size. Its width has the closed
// form step * N cos(latitude) / a.
TEST(ReaderPlace, WebMercatorIsMeasured)
{
  const auto image = ReadAt("EPSG:3857", { -13700000, 1000, 0, 6280000, 0, -1000 });
  const Georeference place = skyline::LoadGeoreference(image);
  double longitude = 0.0, latitude = 0.0;
  place.LonLatAt(2, 2, longitude, latitude);
  EXPECT_NEAR(latitude, 49.06, 0.05);
  ExpectRelative(image->GetSpacing()[0],
    1000.0 * ParallelRadius(place, latitude) / place.EquatorialRadius, SpacingTolerance);
  EXPECT_LT(image->GetSpacing()[1], 660.0);
}

TEST(ReaderPlace, GeographicRowsShrinkNorthwards)
{
  // From the equator to 60 degrees, with one post per degree.
  const auto image = ReadAt("EPSG:4326", { 9.5, 1, 0, 60.5, 0, -1 }, 3, 61);
  const Georeference place = skyline::LoadGeoreference(image);
  ASSERT_EQ(place.RowSpacingX.size(), 61u);
  // Here the chord of a geodesic over one degree is at most 1.3e-5 shorter than the parallel.
  const double chord = 5e-5;
  ExpectRelative(place.RowSpacingX[0], 111319.491, chord);
  ExpectRelative(place.RowSpacingX[60], ParallelRadius(place, 60.0) * RadiansPerDegree, chord);
  ExpectRelative(place.RowSpacingY[0], 110574.3, 1e-6);  // a degree of meridian at latitude 0
  ExpectRelative(place.RowSpacingY[45], 111131.8, 1e-5); // and at latitude 45
  EXPECT_EQ(image->GetSpacing()[0], place.RowSpacingX[30]);
  EXPECT_EQ(image->GetOrigin()[0], 0.0);
  EXPECT_EQ(image->GetOrigin()[1], 0.0);
}

// A part of a geographic raster has the same spacing as the whole, so that cutting it out moves no
// post.
TEST(ReaderPlace, RowSpacingOfAPart)
{
  Recipe recipe;
  recipe.Crs = "EPSG:4326";
  recipe.Transform = { 9.5, 1, 0, 60.5, 0, -1 };
  recipe.Columns = 4;
  recipe.Lines = 61;
  const std::string file = Make(recipe);
  const Georeference whole = skyline::LoadGeoreference(Read(file)->GetOutput());
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(file.c_str());
  const int extent[6] = { 1, 2, 40, 49, 0, 0 };
  reader->UpdateExtent(extent);
  const Georeference part = skyline::LoadGeoreference(reader->GetOutput());
  ASSERT_EQ(part.RowSpacingX.size(), 10u);
  for (std::size_t row = 0; row < 10; ++row)
  {
    EXPECT_EQ(part.RowSpacingX[row], whole.RowSpacingX[40 + row]);
    EXPECT_EQ(part.RowSpacingY[row], whole.RowSpacingY[40 + row]);
  }
  EXPECT_EQ(reader->GetOutput()->GetSpacing()[0], whole.RowSpacingX[30]);
  double longitude = 0.0, latitude = 0.0;
  part.LonLatAt(0, 0, longitude, latitude);
  EXPECT_NEAR(longitude, 11.0, 1e-9);
  EXPECT_NEAR(latitude, 40.0, 1e-9);
}

// On a sphere a degree of a meridian is pi R / 180.
TEST(ReaderPlace, TheMoonIsNotTheEarth)
{
  const std::string crs =
    "GEOGCRS[\"Moon (2015) - Sphere / Ocentric\",DATUM[\"Moon (2015) - Sphere\","
    "ELLIPSOID[\"Moon (2015) - Sphere\",1737400,0,LENGTHUNIT[\"metre\",1]]],"
    "PRIMEM[\"Reference Meridian\",0],CS[ellipsoidal,2],"
    "AXIS[\"geodetic latitude (Lat)\",north,ORDER[1],ANGLEUNIT[\"degree\",0.0174532925199433]],"
    "AXIS[\"geodetic longitude (Lon)\",east,ORDER[2],ANGLEUNIT[\"degree\",0.0174532925199433]]]";
  const auto image = ReadAt(crs, { 20, 0.01, 0, 60.025, 0, -0.01 });
  const Georeference place = skyline::LoadGeoreference(image);
  EXPECT_FALSE(place.Earth);
  EXPECT_EQ(place.EquatorialRadius, 1737400.0);
  EXPECT_EQ(place.Flattening, 0.0);
  const double step = 1737400.0 * 0.01 * RadiansPerDegree;
  ExpectRelative(image->GetSpacing()[1], step, SpacingTolerance);
  ExpectRelative(
    image->GetSpacing()[0], step * std::cos(60.0 * RadiansPerDegree), SpacingTolerance);
}

TEST(ReaderPlace, MarsHasItsOwnEllipsoid)
{
  const std::string crs =
    "PROJCRS[\"Mars equirectangular\",BASEGEOGCRS[\"Mars (2015)\",DATUM[\"Mars (2015)\","
    "ELLIPSOID[\"Mars (2015)\",3396190,169.894447223612,LENGTHUNIT[\"metre\",1]]],"
    "PRIMEM[\"Reference Meridian\",0]],CONVERSION[\"Equirectangular\","
    "METHOD[\"Equidistant Cylindrical\",ID[\"EPSG\",1028]],"
    "PARAMETER[\"Latitude of 1st standard parallel\",0,ANGLEUNIT[\"degree\",0.0174532925199433]],"
    "PARAMETER[\"Longitude of natural origin\",0,ANGLEUNIT[\"degree\",0.0174532925199433]],"
    "PARAMETER[\"False easting\",0,LENGTHUNIT[\"metre\",1]],"
    "PARAMETER[\"False northing\",0,LENGTHUNIT[\"metre\",1]]],CS[Cartesian,2],"
    "AXIS[\"(E)\",east,ORDER[1],LENGTHUNIT[\"metre\",1]],"
    "AXIS[\"(N)\",north,ORDER[2],LENGTHUNIT[\"metre\",1]]]";
  // Gale crater, 4.6 S, 137.4 E. Along a parallel the map is 0.3 % too long; the true length is
  // used.
  const auto image = ReadAt(crs, { 8144000, 100, 0, -272000, 0, -100 });
  const Georeference place = skyline::LoadGeoreference(image);
  EXPECT_FALSE(place.Earth);
  EXPECT_EQ(place.EquatorialRadius, 3396190.0);
  EXPECT_NEAR(1.0 / place.Flattening, 169.894447223612, 1e-9);
  double longitude = 0.0, latitude = 0.0;
  place.LonLatAt(2, 2, longitude, latitude);
  ExpectRelative(image->GetSpacing()[0],
    100.0 * ParallelRadius(place, latitude) / place.EquatorialRadius, SpacingTolerance);
  place.LonLatAt(0, 4, longitude, latitude);
  const double degree = 3396190.0 * RadiansPerDegree;
  EXPECT_NEAR(longitude, 8144050.0 / degree, 1e-9);
  EXPECT_NEAR(latitude, -4.6, 0.1); // geodetic latitude, therefore not exactly y / degree
}

// The CRS of Paris counts longitudes in grads from its own meridian; the position of the sun needs
// degrees from Greenwich.
TEST(ReaderPlace, GradsFromParisBecomeDegreesFromGreenwich)
{
  const auto image = ReadAt("EPSG:4807", { 0, 0.01, 0, 50, 0, -0.01 });
  const Georeference place = skyline::LoadGeoreference(image);
  double longitude = 0.0, latitude = 0.0;
  place.LonLatAt(0, 4, longitude, latitude);
  EXPECT_NEAR(longitude, 2.33722917 + 0.005 * 0.9, 1e-8); // the number of digits of that meridian
  EXPECT_NEAR(latitude, 49.995 * 0.9, 1e-9);
  ExpectRelative(image->GetSpacing()[0],
    ParallelRadius(place, 49.975 * 0.9) * 0.009 * RadiansPerDegree, SpacingTolerance);
}

// There is no datum shift: coordinates in NAD27 stay in NAD27, in accordance with the ellipsoid.
TEST(ReaderPlace, LongitudesAreTheCrssOwn)
{
  const auto image = ReadAt("EPSG:4267", { -122.5, 0.1, 0, 46.5, 0, -0.1 });
  double longitude = 0.0, latitude = 0.0;
  skyline::LoadGeoreference(image).LonLatAt(0, 0, longitude, latitude);
  EXPECT_NEAR(longitude, -122.45, 1e-12);
  EXPECT_NEAR(latitude, 46.05, 1e-12);
}

TEST(ReaderPlace, LongitudesDoNotJumpAtTheAntimeridian)
{
  for (const auto& [crs, transform] : std::vector<std::pair<std::string, std::vector<double>>>{
         { "EPSG:4326", { 179.0, 0.5, 0, 10, 0, -0.5 } },  // 179 to 181.5
         { "EPSG:4326", { -181.0, 0.5, 0, 10, 0, -0.5 } }, // -181 to -178.5
         { "EPSG:32660", { 800000, 20000, 0, 1100000, 0, -20000 } } })
  {
    const Georeference place = skyline::LoadGeoreference(ReadAt(crs, transform));
    double least = 1e9, greatest = -1e9;
    for (const double longitude : place.Longitude)
    {
      least = std::min(least, longitude);
      greatest = std::max(greatest, longitude);
    }
    EXPECT_LT(greatest - least, 3.0) << crs;
  }
}

// A raster whose outermost posts are the poles, with a geotransform that is rounded beyond them.
TEST(ReaderPlace, PolesBelongToTheBody)
{
  const auto image = ReadAt("EPSG:4326", { -0.5, 1, 0, 90.5000001, 0, -1 }, 5, 3);
  const Georeference place = skyline::LoadGeoreference(image);
  EXPECT_EQ(place.Latitude.back(), 90.0);
  ASSERT_EQ(place.RowSpacingX.size(), 3u);
  EXPECT_GT(place.RowSpacingX[2], 0.0);

  const auto polar = ReadAt("EPSG:3031", { -250, 100, 0, 250, 0, -100 });
  EXPECT_NEAR(
    polar->GetSpacing()[0], 100.0 / 0.9728, 0.1); // true scale at 71 S, 0.9728 at the pole
}

// The Albers map of the United States, in California: the angle between grid north and true north
// is n (lambda - lambda0), with n = (sin 29.5 + sin 45.5) / 2 on the sphere. The ellipsoid changes
// n by 2e-4.
TEST(ReaderPlace, AlbersConvergence)
{
  const Georeference place = skyline::LoadGeoreference(
    ReadAt("+proj=aea +lat_0=23 +lon_0=-96 +lat_1=29.5 +lat_2=45.5 +datum=NAD83 +type=crs",
      { -2033450.108, 6600, 0, 1840000, 0, -6600 }, 6, 6));
  double longitude = 0.0, latitude = 0.0;
  place.LonLatAt(2.5, 2.5, longitude, latitude);
  const double n = 0.5 * (std::sin(29.5 * RadiansPerDegree) + std::sin(45.5 * RadiansPerDegree));
  EXPECT_NEAR(place.ConvergenceAt(2.5, 2.5), n * (longitude + 96.0), 0.02);
  EXPECT_NEAR(std::abs(place.ConvergenceAt(2.5, 2.5)), 14.0, 1.0);
}

// Degrees relative to a rotated pole: the distance of columns depends on the rotated latitude, not
// on the true one.
TEST(ReaderPlace, RotatedPole)
{
  const std::string crs =
    "GEOGCRS[\"Rotated_pole\",BASEGEOGCRS[\"base\",DATUM[\"d\",ELLIPSOID[\"Sphere\",6371229,0,"
    "LENGTHUNIT[\"metre\",1]]],PRIMEM[\"Greenwich\",0,ANGLEUNIT[\"degree\",0.0174532925199433]]],"
    "DERIVINGCONVERSION[\"Pole rotation (netCDF CF convention)\","
    "METHOD[\"Pole rotation (netCDF CF convention)\"],"
    "PARAMETER[\"Grid north pole latitude (netCDF CF convention)\",39.25,"
    "ANGLEUNIT[\"degree\",0.0174532925199433]],"
    "PARAMETER[\"Grid north pole longitude (netCDF CF convention)\",198,"
    "ANGLEUNIT[\"degree\",0.0174532925199433]],"
    "PARAMETER[\"North pole grid longitude (netCDF CF convention)\",0,"
    "ANGLEUNIT[\"degree\",0.0174532925199433]]],CS[ellipsoidal,2],"
    "AXIS[\"latitude\",north,ORDER[1],ANGLEUNIT[\"degree\",0.0174532925199433]],"
    "AXIS[\"longitude\",east,ORDER[2],ANGLEUNIT[\"degree\",0.0174532925199433]]]";
  // A GeoTIFF cannot store this CRS, but a virtual raster can.
  std::string escaped = crs;
  for (std::size_t at = 0; (at = escaped.find('"', at)) != std::string::npos;)
  {
    escaped.replace(at, 1, "&quot;");
  }
  const vtkSmartPointer<vtkImageData> image =
    Read("<VRTDataset rasterXSize=\"21\" rasterYSize=\"21\"><SRS>" + escaped +
      "</SRS><GeoTransform>-10.105,0.01,0,20.105,0,-0.01</GeoTransform>"
      "<VRTRasterBand dataType=\"Byte\" band=\"1\"/></VRTDataset>")
      ->GetOutput();
  const Georeference place = skyline::LoadGeoreference(image);
  EXPECT_TRUE(place.InDegrees);
  EXPECT_TRUE(place.RowSpacingX.empty());
  const double step = 6371229.0 * 0.01 * RadiansPerDegree;
  ExpectRelative(image->GetSpacing()[1], step, SpacingTolerance);
  ExpectRelative(
    image->GetSpacing()[0], step * std::cos(20.0 * RadiansPerDegree), SpacingTolerance);
}

// Krovak with axes to the south and west: seen from above, the columns of the file run from right
// to left.
TEST(ReaderPlace, MirroredAxesAreTurned)
{
  const auto image = ReadAt("EPSG:5513", { 1040000, 10, 0, 870000, 0, -10 });
  const Georeference place = skyline::LoadGeoreference(image);
  const skyline::PostSteps steps = place.StepsAt(2, 2);
  EXPECT_GT(steps.EastPerColumn * steps.NorthPerRow, steps.EastPerRow * steps.NorthPerColumn);
  EXPECT_EQ(HeightAt(image, 0, 4), 4.0); // the last post of the first line
  EXPECT_LT(place.GeoTransform[1], 0.0);
}

// A compound CRS: its horizontal part determines the positions, and all of it is kept.
TEST(ReaderPlace, CompoundCrs)
{
  const auto image = ReadAt("EPSG:26910+5703", { 500000, 10, 0, 5100000, 0, -10 });
  const Georeference place = skyline::LoadGeoreference(image);
  EXPECT_TRUE(place.OnBody());
  EXPECT_TRUE(CrsFrom(place.Crs).IsCompound());
}
