// SPDX-License-Identifier: BSD-3-Clause
// Errors of the irradiance by number of azimuths, compared with a sum over all pixels of a light
// map above the exact horizon, at random posts:
//   SkylineIrradianceStudy DEM POSTS [COLUMN ROW COLUMNS ROWS] [MAP.hdr|MAP.exr]...
// The four numbers select a part of the DEM, by its south-western post and its size. The program
// always measures a uniform sky, a clear sky, and a map with one pixel of 1e5 times the mean. The
// last table is for azimuths that are placed where horizons vary.
#include "PlacedAzimuths.h"
#include "Reference/FieldImage.h"
#include "Reference/LightOracle.h"
#include "Reference/PublishedTable.h"
#include "SizeArgument.h"
#include "Sky/LightAzimuths.h"
#include "Sky/SkyModel.h"

#include "Data/LightMapImage.h"
#include "vtkHeightFieldReader.h"
#include "vtkSkylineLightMapReader.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace skyline
{
namespace testing
{
namespace
{

/// Azimuths of the reference: 7 per pixel of a map with 1024 columns.
constexpr int ReferenceAzimuths = 7168;

struct NamedMap
{
  std::string Name;
  OwnedMap Map;
};

struct Terrain
{
  oracle::OracleField Field;
  std::vector<std::ptrdiff_t> Chosen;
  std::vector<std::vector<double>> Horizon; // elevations for each chosen post
};

Terrain ReadTerrain(const std::string& file, const std::vector<int>& part, int posts)
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  const int* size = image->GetDimensions();
  const std::vector<int> box = part.empty() ? std::vector<int>{ 0, 0, size[0], size[1] } : part;
  Terrain terrain;
  terrain.Field =
    oracle::OracleField(box[2], box[3], image->GetSpacing()[0], image->GetSpacing()[1]);
  for (std::ptrdiff_t row = 0; row < box[3]; ++row)
  {
    for (std::ptrdiff_t column = 0; column < box[2]; ++column)
    {
      terrain.Field.At(column, row) = image->GetPointData()->GetScalars()->GetComponent(
        (row + box[1]) * size[0] + column + box[0], 0);
    }
  }
  shapes::Random random(1);
  while (static_cast<int>(terrain.Chosen.size()) < posts)
  {
    const std::ptrdiff_t column = random.Below(box[2]), row = random.Below(box[3]);
    if (!terrain.Field.HasPost(column, row))
    {
      continue;
    }
    terrain.Chosen.push_back(row * box[2] + column);
    terrain.Horizon.emplace_back();
    for (int a = 0; a < ReferenceAzimuths; ++a)
    {
      terrain.Horizon.back().push_back(std::atan(oracle::HorizonSlope(
        terrain.Field, column, row, -Pi + 2.0 * Pi * (a + 0.5) / ReferenceAzimuths)));
    }
  }
  return terrain;
}

OwnedMap ReadMap(const std::string& file)
{
  vtkNew<vtkSkylineLightMapReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  const LightMap view = ViewLightMap(reader->GetOutput());
  OwnedMap map(view.Columns, view.Rows);
  for (std::ptrdiff_t row = 0; row < view.Rows; ++row)
  {
    std::copy_n(view.Pixel(row, 0), 3 * view.Columns, map.At(0, row));
  }
  return map;
}

/// Prints median, 95th percentile and maximum.
void PrintErrors(std::vector<double>& errors)
{
  std::sort(errors.begin(), errors.end());
  std::printf(" %.3f / %.3f / %.2f |", errors[errors.size() / 2], errors[errors.size() * 95 / 100],
    errors.back());
}

/// The light of all posts by the published method: evenly spaced azimuths, and for each a table of
/// 15 angles of the normal by 256 angles of the horizon. The sum of red, green and blue.
std::vector<double> PublishedLight(const Terrain& terrain, const OwnedMap& map, int count,
  const std::vector<float>& east, const std::vector<float>& north)
{
  std::vector<double> light(terrain.Chosen.size(), 0.0);
  const double width = 2.0 * Pi / count;
  for (int k = 0; k < count; ++k)
  {
    const double azimuth = width * k;
    constexpr int Strips = 64;
    std::vector<double> rows(static_cast<std::size_t>(map.Rows), 0.0);
    for (int s = 0; s < Strips; ++s)
    {
      const double place = (azimuth + width * ((s + 0.5) / Strips - 0.5) + Pi) / (2.0 * Pi);
      const auto column =
        static_cast<std::ptrdiff_t>((place - std::floor(place)) * static_cast<double>(map.Columns));
      for (std::ptrdiff_t row = 0; row < map.Rows / 2; ++row)
      {
        const float* pixel = map.Pixels.data() + 3 * (row * map.Columns + column);
        rows[static_cast<std::size_t>(row)] +=
          (static_cast<double>(pixel[0]) + pixel[1] + pixel[2]) / Strips;
      }
    }
    const PublishedTable table(
      [&](double zenith)
      {
        return rows[std::min(rows.size() - 1,
          static_cast<std::size_t>(zenith / Pi * static_cast<double>(rows.size())))];
      },
      width, 15, 256);
    for (std::size_t p = 0; p < light.size(); ++p)
    {
      const std::ptrdiff_t post = terrain.Chosen[p];
      const double slope = oracle::HorizonSlope(
        terrain.Field, post % terrain.Field.Columns, post / terrain.Field.Columns, azimuth);
      const double ge = static_cast<double>(east[p]), gn = static_cast<double>(north[p]);
      const double rise = ge * std::sin(azimuth) + gn * std::cos(azimuth);
      const double length = std::sqrt((1.0 + rise * rise) / (1.0 + ge * ge + gn * gn));
      light[p] += length * table(std::atan(-rise), 0.5 * Pi - std::atan(slope));
    }
  }
  return light;
}

void Measure(const Terrain& terrain, const NamedMap& named)
{
  const auto posts = terrain.Chosen.size();
  std::vector<float> east, north;
  std::vector<Color> truth;
  for (std::size_t k = 0; k < posts; ++k)
  {
    double ge = 0.0, gn = 0.0;
    oracle::Gradient(terrain.Field, terrain.Chosen[k] % terrain.Field.Columns,
      terrain.Chosen[k] / terrain.Field.Columns, ge, gn);
    east.push_back(static_cast<float>(ge));
    north.push_back(static_cast<float>(gn));
    const auto horizon = [&](double azimuth)
    {
      return terrain.Horizon[k][static_cast<std::size_t>(
        std::min((azimuth + Pi) / (2.0 * Pi), 1.0 - 1e-12) * ReferenceAzimuths)];
    };
    truth.push_back(BruteLight(named.Map, 0.0, horizon, ge, gn, ReferenceAzimuths));
  }
  const std::vector<TurnedLightMap> maps{ { named.Map.View(), 0.0 } };
  for (const int count : { 16, 32, 64, 128, 256 })
  {
    const std::vector<double> azimuths = LightAzimuths(count, maps);
    std::printf("| %s | %d | %zu |", named.Name.c_str(), count, azimuths.size());
    for (const SwathQuadrature quadrature :
      { SwathQuadrature::Constant, SwathQuadrature::Blend, SwathQuadrature::Linear })
    {
      std::vector<float> light(3 * posts);
      LightAccumulator::Options options;
      options.Quadrature = quadrature;
      LightAccumulator sum(static_cast<std::ptrdiff_t>(posts), 1, maps, azimuths, options,
        east.data(), north.data(), light.data());
      std::vector<float> slopes(posts);
      for (const double azimuth : sum.HorizonAzimuths())
      {
        for (std::size_t k = 0; k < posts; ++k)
        {
          const std::ptrdiff_t post = terrain.Chosen[k];
          slopes[k] = static_cast<float>(oracle::HorizonSlope(
            terrain.Field, post % terrain.Field.Columns, post / terrain.Field.Columns, azimuth));
        }
        sum.Begin(azimuth, 0.0);
        sum.Add(0, 0, static_cast<std::ptrdiff_t>(posts), slopes.data());
      }
      sum.Finish(0, 1);
      std::vector<double> errors;
      for (std::size_t k = 0; k < posts; ++k)
      {
        double found = 0.0, right = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
        {
          found += static_cast<double>(light[3 * k + c]);
          right += truth[k][c];
        }
        errors.push_back(100.0 * std::abs(found / right - 1.0));
      }
      PrintErrors(errors);
    }
    const std::vector<double> published = PublishedLight(terrain, named.Map, count, east, north);
    std::vector<double> errors;
    for (std::size_t k = 0; k < posts; ++k)
    {
      errors.push_back(
        100.0 * std::abs(published[k] / (truth[k][0] + truth[k][1] + truth[k][2]) - 1.0));
    }
    PrintErrors(errors);
    std::printf("\n");
    std::fflush(stdout);
  }
}

/// Compares evenly spaced azimuths with azimuths that are placed by the horizons of every other
/// post, or by those of each post, under a uniform sky. The errors are those of the posts in
/// between.
void MeasurePlaced(const Terrain& terrain)
{
  std::vector<AzimuthLight> lights;
  for (std::size_t k = 0; k < terrain.Chosen.size(); ++k)
  {
    double ge = 0.0, gn = 0.0;
    oracle::Gradient(terrain.Field, terrain.Chosen[k] % terrain.Field.Columns,
      terrain.Chosen[k] / terrain.Field.Columns, ge, gn);
    AzimuthLight light;
    double sum = 0.0;
    for (int a = 0; a < ReferenceAzimuths; ++a)
    {
      light.push_back(UniformLight(terrain.Horizon[k][static_cast<std::size_t>(a)],
        -Pi + 2.0 * Pi * (a + 0.5) / ReferenceAzimuths, ge, gn));
      sum += light.back();
    }
    for (double& value : light)
    {
      value *= ReferenceAzimuths / sum;
    }
    lights.push_back(std::move(light));
  }
  std::vector<const AzimuthLight*> known;
  for (std::size_t k = 0; k < lights.size(); k += 2)
  {
    known.push_back(&lights[k]);
  }
  std::printf("\n| azimuths | even | placed by the field's horizons | by each post's own |\n"
              "| --- | --- | --- | --- |\n");
  for (const std::size_t count : { 32u, 64u, 128u, 256u, 512u })
  {
    std::vector<std::size_t> even;
    for (std::size_t a = 0; a < ReferenceAzimuths; a += ReferenceAzimuths / count)
    {
      even.push_back(a);
    }
    const std::vector<std::size_t> placed = PlaceAzimuths(known, count);
    std::vector<double> errors[3];
    for (std::size_t k = 1; k < lights.size(); k += 2)
    {
      errors[0].push_back(PlacedError(lights[k], even));
      errors[1].push_back(PlacedError(lights[k], placed));
      errors[2].push_back(PlacedError(lights[k], PlaceAzimuths({ &lights[k] }, count)));
    }
    std::printf("| %zu |", count);
    for (std::vector<double>& found : errors)
    {
      PrintErrors(found);
    }
    std::printf("\n");
  }
}

} // namespace
} // namespace testing
} // namespace skyline

int main(int argc, char** argv)
{
  using namespace skyline::testing;
  std::vector<int> part;
  int next = 3;
  for (; next < 7 && skyline::SizeArgument(argc, argv, next, -1) >= 0; ++next)
  {
    part.push_back(skyline::SizeArgument(argc, argv, next, -1));
  }
  const int posts = skyline::SizeArgument(argc, argv, 2, -1);
  if (posts < 1 || (!part.empty() && part.size() != 4))
  {
    std::fprintf(stderr, "usage: %s DEM POSTS [COLUMN ROW COLUMNS ROWS] [MAP]...\n", argv[0]);
    return 2;
  }
  const Terrain terrain = ReadTerrain(argv[1], part, posts);
  std::vector<NamedMap> maps{ { "uniform", OwnedMap(8, 4, 1.0f) },
    { "cie:12", OwnedMap(skyline::SkyWidth, skyline::SkyHeight) },
    { "one pixel of 1e5", SunnyMap(1024, 512, 131.0, 24.0) } };
  skyline::FillSky(skyline::CieSky(12), 2.0, 0.7, {}, skyline::SkyWidth, skyline::SkyHeight,
    maps[1].Map.Pixels.data());
  for (; next < argc; ++next)
  {
    const std::string file = argv[next];
    maps.push_back({ file.substr(file.rfind('/') + 1), ReadMap(file) });
  }
  std::printf("| light | azimuths | searched | constant | blend | linear | as published |\n"
              "| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const NamedMap& map : maps)
  {
    Measure(terrain, map);
  }
  MeasurePlaced(terrain);
  return 0;
}
