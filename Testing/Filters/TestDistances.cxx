// SPDX-License-Identifier: BSD-3-Clause
// Distances and azimuths of horizons, compared with geodesics on many maps. `TestDistances --table`
// prints the table of Documentation/distances.md.
#include "GroundCases.h"

#include "Data/ImageGeoreference.h"
#include "Geo/RayFan.h"
#include "HorizonDriver.h"
#include "Shared/Constants.h"
#include "vtkHeightFieldReader.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <GeographicLib/Geodesic.hpp>
#include <cpl_error.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

namespace skyline
{
namespace
{

constexpr int Posts = 161;
constexpr double Step = 150.0; // metres on the map, roughly: a raster of 24 km, towers 1.2 km away
constexpr int Reach = 8;       // posts from a receiver to its tower, or a little more
constexpr double Rise = 0.3;   // height of a tower divided by its distance
constexpr double Turn = 0.01;  // degrees between the azimuths of the search
constexpr int Turns = 15;      // on each side

// The bounds of Documentation/distances.md, plus the errors of this test: where columns and rows
// meet at 23 degrees, half a step of azimuth makes 0.02 % of the distance to the edge of a tower,
// and the curvature of the ray makes 0.01 %.
constexpr double DistanceBound = DistanceTolerance + 3e-4;
constexpr double AzimuthBound = AzimuthTolerance + 0.5 * Turn;

std::string Escaped(const std::string& text)
{
  char* escaped = CPLEscapeString(text.c_str(), -1, CPLES_XML);
  const std::string result = escaped;
  CPLFree(escaped);
  return result;
}

OGRSpatialReference CrsOf(const std::string& text)
{
  OGRSpatialReference crs;
  EXPECT_EQ(crs.SetFromUserInput(text.c_str()), OGRERR_NONE) << text;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

/// Longitudes and latitudes on the ellipsoid of the CRS, computed by PROJ for each point instead of
/// by the lattice.
class Truth
{
public:
  explicit Truth(const std::string& text)
    : Crs(CrsOf(text))
    , Geodesic(
        Crs.GetSemiMajor(), Crs.GetInvFlattening() > 0.0 ? 1.0 / Crs.GetInvFlattening() : 0.0)
  {
    OGRSpatialReference degrees;
    degrees.SetGeogCS("own", "own", "own", this->Crs.GetSemiMajor(), this->Crs.GetInvFlattening());
    degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    this->To.reset(OGRCreateCoordinateTransformation(&this->Crs, &degrees));
    this->From.reset(OGRCreateCoordinateTransformation(&degrees, &this->Crs));
  }

  std::array<double, 2> LonLat(double x, double y) const
  {
    EXPECT_TRUE(this->To->Transform(1, &x, &y));
    return { { x, y } };
  }
  std::array<double, 2> OnMap(double longitude, double latitude) const
  {
    EXPECT_TRUE(this->From->Transform(1, &longitude, &latitude));
    return { { longitude, latitude } };
  }

  OGRSpatialReference Crs;
  GeographicLib::Geodesic Geodesic;

private:
  std::unique_ptr<OGRCoordinateTransformation> To, From;
};

/// Stores the slopes of one post.
class OnePost : public Accumulator
{
public:
  OnePost(std::ptrdiff_t column, std::ptrdiff_t row)
    : Column(column)
    , Row(row)
  {
  }
  void Begin(double, double) override {}
  void Add(
    std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count, const float* slopes) override
  {
    if (row == this->Row && column <= this->Column && this->Column < column + count)
    {
      this->Slopes.push_back(slopes[this->Column - column]);
    }
  }
  void Finish(std::ptrdiff_t, std::ptrdiff_t) override {}

  std::vector<float> Slopes;

private:
  std::ptrdiff_t Column, Row;
};

struct Worst
{
  double Distance = 0.0, Azimuth = 0.0;
  std::size_t Rays = 0;
};

class Map
{
public:
  explicit Map(const GroundCase& which)
    : Place(which.Crs)
  {
    const std::array<double, 2> centre = this->Place.OnMap(which.Longitude, which.Latitude);
    const bool degrees = this->Place.Crs.IsGeographic() != 0;
    const double unit = degrees ? this->Place.Crs.GetSemiMajor() * RadiansPerDegree
                                : this->Place.Crs.GetLinearUnits();
    double stepX = Step / unit;
    const double stepY = Step / unit;
    if (degrees)
    {
      stepX /= std::max(0.05, std::cos(centre[1] * RadiansPerDegree));
    }
    this->Transform = { { centre[0] - 0.5 * Posts * stepX, stepX, 0.0,
      centre[1] + 0.5 * Posts * stepY, 0.0, -stepY } };
    std::string text = "<VRTDataset rasterXSize=\"" + std::to_string(Posts) + "\" rasterYSize=\"" +
      std::to_string(Posts) + "\"><SRS>" + Escaped(this->Wkt()) + "</SRS><GeoTransform>";
    for (std::size_t i = 0; i < 6; ++i)
    {
      char number[40];
      std::snprintf(number, sizeof(number), "%s%.17g", i ? "," : "", this->Transform[i]);
      text += number;
    }
    text += "</GeoTransform><VRTRasterBand dataType=\"Byte\" band=\"1\"/></VRTDataset>";
    vtkNew<vtkHeightFieldReader> reader;
    reader->SetFileName(text.c_str());
    reader->Update();
    this->Image->ShallowCopy(reader->GetOutput());
  }

  bool Read() const { return this->Image->GetNumberOfPoints() == Posts * Posts; }

  /// Longitude and latitude of a post, by PROJ.
  std::array<double, 2> At(double column, double row) const
  {
    const double line = Posts - 1 - row;
    return this->Place.LonLat(
      this->Transform[0] + (this->FlipX ? Posts - 0.5 - column : column + 0.5) * this->Transform[1],
      this->Transform[3] + (this->FlipY ? Posts - 0.5 - line : line + 0.5) * this->Transform[5]);
  }

  Worst Measure()
  {
    const Georeference place = LoadGeoreference(this->Image);
    // The reader turns maps whose axes point south or west. The positions of the posts tell how.
    double longitude = 0.0, latitude = 0.0, nearest = 1e30;
    place.LonLatAt(3.0, 1.0, longitude, latitude);
    bool flipX = false, flipY = false;
    for (const int flips : { 0, 1, 2, 3 })
    {
      this->FlipX = (flips & 1) != 0;
      this->FlipY = (flips & 2) != 0;
      const std::array<double, 2> post = this->At(3.0, 1.0);
      const double off = std::hypot(post[1] - latitude, std::remainder(post[0] - longitude, 360.0));
      if (off < nearest)
      {
        nearest = off;
        flipX = this->FlipX;
        flipY = this->FlipY;
      }
    }
    this->FlipX = flipX;
    this->FlipY = flipY;
    Worst worst;
    // For a tower beside the corner, the nearest point lies inside the raster.
    constexpr int first = Reach, last = Posts - 1 - Reach, middle = Posts / 2;
    for (const auto& [column, row] : { std::pair<int, int>{ middle, middle }, { first, first },
           { last, first }, { first, last }, { last, last } })
    {
      const int inwardX = column == last ? -1 : 1, inwardY = row == last ? -1 : 1;
      for (const auto& [east, north] :
        { std::pair<int, int>{ Reach, 0 }, { 1, Reach }, { Reach - 1, Reach - 3 } })
      {
        this->Measure(place, column, row, column + inwardX * east, row + inwardY * north, worst);
      }
    }
    return worst;
  }

private:
  std::string Wkt() const
  {
    char* text = nullptr;
    const char* const options[] = { "FORMAT=WKT2_2019", nullptr };
    this->Place.Crs.exportToWkt(&text, options);
    const std::string wkt = text;
    CPLFree(text);
    return wkt;
  }

  void Measure(
    const Georeference& place, int column, int row, int towerColumn, int towerRow, Worst& worst)
  {
    const std::array<double, 2> here = this->At(column, row);
    // The nearest point of a flat top of 3 x 3 posts, and the tip of a peak of one post.
    double nearest = 1e30, towards = 0.0, tip = 0.0, tipTowards = 0.0;
    const auto look = [&](double c, double r, double& length, double& azimuth)
    {
      const std::array<double, 2> there = this->At(c, r);
      double back = 0.0;
      this->Place.Geodesic.Inverse(here[1], here[0], there[1], there[0], length, azimuth, back);
    };
    constexpr int parts = 100;
    for (int k = -parts; k <= parts; ++k)
    {
      for (const auto& [c, r] : { std::pair<double, double>{ k * 1.0 / parts, -1.0 },
             { k * 1.0 / parts, 1.0 }, { -1.0, k * 1.0 / parts }, { 1.0, k * 1.0 / parts } })
      {
        double length = 0.0, azimuth = 0.0;
        look(towerColumn + c, towerRow + r, length, azimuth);
        if (length < nearest)
        {
          nearest = length;
          towards = azimuth;
        }
      }
    }
    look(towerColumn, towerRow, tip, tipTowards);

    double found = 0.0;
    const float tower = this->Highest(place, column, row, towerColumn, towerRow, 1, Rise * nearest,
      towards, AzimuthAxes::Ground, worst, found);
    worst.Distance = std::max(worst.Distance, std::abs(Rise / tower - 1.0));
    const float image = this->Highest(place, column, row, towerColumn, towerRow, 1, Rise * nearest,
      towards, AzimuthAxes::Image, worst, found);
    worst.Distance = std::max(worst.Distance, std::abs(Rise / image - 1.0));
    for (const AzimuthAxes axes : { AzimuthAxes::Ground, AzimuthAxes::Image })
    {
      this->Highest(
        place, column, row, towerColumn, towerRow, 0, Rise * tip, tipTowards, axes, worst, found);
      worst.Azimuth = std::max(worst.Azimuth, std::abs(found));
    }
  }

  /// Returns the highest slope near a true azimuth, without curvature. found: its direction, in
  /// degrees from this azimuth.
  float Highest(const Georeference& place, int column, int row, int towerColumn, int towerRow,
    int half, double height, double trueAzimuth, AzimuthAxes axes, Worst& worst, double& found)
  {
    vtkNew<vtkFloatArray> heights;
    heights->SetName("Elevation");
    heights->SetNumberOfTuples(Posts * Posts);
    heights->FillValue(0.0f);
    for (int r = std::max(0, towerRow - half); r <= std::min(Posts - 1, towerRow + half); ++r)
    {
      for (int c = std::max(0, towerColumn - half); c <= std::min(Posts - 1, towerColumn + half);
           ++c)
      {
        heights->SetValue(r * Posts + c, static_cast<float>(height));
      }
    }
    HorizonInput input(this->Image, heights);
    HorizonDriver driver(input, HorizonSettings());
    // Azimuths relative to one of the axes, as the driver counts them. Within a degree, all of them
    // turn equally.
    const double before = trueAzimuth - Turn * Turns, after = trueAzimuth + Turn * Turns;
    const auto counted = [&](double azimuth)
    {
      return axes == AzimuthAxes::Image ? place.GridAzimuthAt(column, row, azimuth)
                                        : input.Place().AxisAzimuthAt(column, row, azimuth);
    };
    const double from = counted(before);
    const double width = std::remainder(counted(after) - from, 360.0);
    std::vector<double> azimuths;
    for (int k = 0; k <= 2 * Turns; ++k)
    {
      azimuths.push_back((from + width * k / (2.0 * Turns)) * RadiansPerDegree);
    }
    OnePost post(column, row);
    driver.Run(azimuths, 0.0, post, axes);
    const auto highest = std::max_element(post.Slopes.begin(), post.Slopes.end());
    // The middle of the directions in which the slope is the highest, up to rounding.
    const auto high = [&](float slope) { return slope >= *highest * (1.0f - 1e-6f); };
    const auto first = std::find_if(post.Slopes.begin(), post.Slopes.end(), high);
    const auto final = std::find_if(post.Slopes.rbegin(), post.Slopes.rend(), high);
    const double place0 = static_cast<double>(first - post.Slopes.begin());
    const double place1 = static_cast<double>(post.Slopes.rend() - final - 1);
    found = (0.5 * (place0 + place1) - Turns) * Turn;
    worst.Rays = std::max(worst.Rays,
      RayFan(input.Ground(), azimuths.front(), axes == AzimuthAxes::Image, true).Directions.size());
    return *highest;
  }

  Truth Place;
  std::array<double, 6> Transform;
  bool FlipX = false, FlipY = false;
  vtkNew<vtkImageData> Image;
};

class OnMaps : public ::testing::TestWithParam<GroundCase>
{
};

TEST_P(OnMaps, DistancesAndAzimuthsAreThoseOfGeodesics)
{
  Map map(GetParam());
  ASSERT_TRUE(map.Read());
  const Worst worst = map.Measure();
  EXPECT_LT(worst.Distance, DistanceBound);
  EXPECT_LT(worst.Azimuth, AzimuthBound);
}

std::string NameOf(const ::testing::TestParamInfo<GroundCase>& info)
{
  std::string name = info.param.Name;
  name.erase(std::remove_if(name.begin(), name.end(),
               [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }),
    name.end());
  return name;
}

INSTANTIATE_TEST_SUITE_P(Distances, OnMaps, ::testing::ValuesIn(GroundCases()), NameOf);

/// How far a ray deviates from the geodesic that it follows at first, if it is straight on the map
/// and uses the lengths and angles of its receiver. The worst of all directions.
Worst RayError(const GroundCase& which, double distance)
{
  const Truth place(which.Crs);
  const std::array<double, 2> centre = place.OnMap(which.Longitude, which.Latitude);
  const bool degrees = place.Crs.IsGeographic() != 0;
  const double step =
    10.0 / (degrees ? place.Crs.GetSemiMajor() * RadiansPerDegree : place.Crs.GetLinearUnits());
  const auto ground = [&](double x, double y, double& length, double& azimuth)
  {
    const std::array<double, 2> from = place.LonLat(centre[0], centre[1]);
    const std::array<double, 2> to = place.LonLat(centre[0] + x, centre[1] + y);
    double back = 0.0;
    place.Geodesic.Inverse(from[1], from[0], to[1], to[0], length, azimuth, back);
  };
  Worst worst;
  for (int k = 0; k < 72; ++k)
  {
    const double angle = 5.0 * k * RadiansPerDegree;
    const double x = step * std::sin(angle), y = step * std::cos(angle);
    double length = 0.0, before = 0.0, azimuth = 0.0;
    ground(x, y, length, azimuth);
    ground(-x, -y, before, azimuth); // the mean of both directions has no second-order error
    const double perStep = 0.5 * (length + before);
    double there = 0.0;
    const double steps = distance / perStep;
    double first = 0.0, opposite = 0.0;
    ground(x, y, length, first);
    ground(-x, -y, length, opposite);
    const double start = first + 0.5 * std::remainder(opposite + 180.0 - first, 360.0);
    ground(steps * x, steps * y, there, azimuth);
    worst.Distance = std::max(worst.Distance, std::abs(there / distance - 1.0));
    worst.Azimuth = std::max(worst.Azimuth, std::abs(std::remainder(azimuth - start, 360.0)));
  }
  return worst;
}

void PrintRays()
{
  std::printf("| map | 10 km | 50 km | 200 km |\n| --- | --- | --- | --- |\n");
  for (const GroundCase& which : GroundCases())
  {
    std::printf("| %s |", which.Name);
    for (const double distance : { 1e4, 5e4, 2e5 })
    {
      const Worst worst = RayError(which, distance);
      std::printf(" %.2f %%, %.2f\xc2\xb0 |", 100.0 * worst.Distance, worst.Azimuth);
    }
    std::printf("\n");
  }
}

void PrintTable()
{
  std::printf("| map | distance, %% | azimuth, degrees | rays |\n| --- | --- | --- | --- |\n");
  for (const GroundCase& which : GroundCases())
  {
    Map map(which);
    if (!map.Read())
    {
      std::printf("| %s | refused | | |\n", which.Name);
      continue;
    }
    const Worst worst = map.Measure();
    std::printf("| %s | %.3f | %.3f | %zu |\n", which.Name, 100.0 * worst.Distance, worst.Azimuth,
      worst.Rays);
    std::fflush(stdout);
  }
}

} // namespace
} // namespace skyline

int main(int argc, char** argv)
{
  GDALAllRegister();
  if (argc > 1 && std::string(argv[1]) == "--table")
  {
    skyline::PrintTable();
    skyline::PrintRays();
    return 0;
  }
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
