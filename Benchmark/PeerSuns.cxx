// SPDX-License-Identifier: BSD-3-Clause
#include "PeerSuns.h"

#include "GrassLocation.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

namespace skyline
{
namespace benchmark
{

namespace
{

constexpr int Day = 80; // for r.sun; only its distance from the sun matters, not its declination

// Reverses the rows of a raster that begins in the north.
template <typename Value>
std::vector<float> FromNorth(const oracle::OracleField& field, const std::vector<Value>& raster)
{
  const auto columns = static_cast<std::size_t>(field.Columns);
  const auto rows = static_cast<std::size_t>(field.Rows);
  std::vector<float> turned(raster.size());
  for (std::size_t row = 0; row < rows; ++row)
  {
    for (std::size_t column = 0; column < columns; ++column)
    {
      turned[row * columns + column] =
        static_cast<float>(raster[(rows - 1 - row) * columns + column]);
    }
  }
  return turned;
}

struct SagaFolder
{
  explicit SagaFolder(const oracle::OracleField& field)
  {
    WriteSagaGrid(field, this->Folder.File("heights"));
  }
  ScratchFolder Folder;
};

std::shared_ptr<GrassLocation> PlaceInGrass(const oracle::OracleField& field)
{
  const std::string base = FirstLine("grass --config path 2>/dev/null");
  if (base.empty())
  {
    throw std::runtime_error("not installed");
  }
  auto location = std::make_shared<GrassLocation>(field, base);
  location->Import("heights", field.Heights);
  return location;
}

// Slope in degrees, and aspect as in GRASS: anticlockwise from east, 0 if the surface is level.
void ImportSlopes(const GrassLocation& location, const oracle::OracleField& field)
{
  std::vector<double> slope, aspect;
  for (std::ptrdiff_t row = 0; row < field.Rows; ++row)
  {
    for (std::ptrdiff_t column = 0; column < field.Columns; ++column)
    {
      double east = 0.0, north = 0.0;
      oracle::Gradient(field, column, row, east, north);
      const double tilt = std::hypot(east, north);
      slope.push_back(std::atan(tilt) * DegreesPerRadian);
      const double down = std::atan2(-north, -east) * DegreesPerRadian;
      const double left = down > 0.0 ? down : down + 360.0; // 0 would mean a level surface
      aspect.push_back(std::isfinite(tilt) && tilt == 0.0 ? 0.0 : left);
    }
  }
  location.Import("slope", slope);
  location.Import("aspect", aspect);
}

} // namespace

PeerSun SagaSun(const oracle::OracleField& field)
{
  const auto place = std::make_shared<SagaFolder>(field);
  return [place, &field](const SunAt& sun, Cost& cost)
  {
    const ScratchFolder& folder = place->Folder;
    cost += RunProgram({ "saga_cmd", "-c=1", "ta_lighting", "0",
      "-ELEVATION=" + folder.File("heights.sgrd"), "-SHADE=" + folder.File("shade.sgrd"),
      "-METHOD=2", "-AZIMUTH=" + std::to_string(sun.Azimuth),
      "-DECLINATION=" + std::to_string(sun.Elevation) });
    std::vector<float> beam = ReadSagaGrid(field, folder.File("shade"));
    constexpr float dark = 0.4999f * static_cast<float>(Pi); // a right angle marks shadow
    for (float& value : beam)
    {
      value = value < dark ? std::cos(value) : 0.0f;
    }
    return beam;
  };
}

PeerSun GdalSun(const oracle::OracleField& field)
{
  const auto place = std::make_shared<SagaFolder>(field); // GDAL can open SAGA's grids
  return [place, &field](const SunAt& sun, Cost& cost)
  {
    const ScratchFolder& folder = place->Folder;
    cost += RunProgram({ "gdaldem", "hillshade", folder.File("heights.sdat"),
      folder.File("shade.bil"), "-of", "EHdr", "-compute_edges", "-alg", "ZevenbergenThorne", "-az",
      std::to_string(sun.Azimuth), "-alt", std::to_string(sun.Elevation) });
    std::vector<unsigned char> shades(field.Heights.size());
    std::ifstream file(folder.File("shade.bil"), std::ios::binary);
    if (!file.read(
          reinterpret_cast<char*>(shades.data()), static_cast<std::streamsize>(shades.size())))
    {
      throw std::runtime_error("gdaldem wrote too little");
    }
    std::vector<float> beam = FromNorth(field, shades);
    for (float& value : beam)
    {
      value = std::max(0.0f, value - 1.0f) / 254.0f; // 0: no data, 1: black
    }
    return beam;
  };
}

PeerSun GrassSunMask(const oracle::OracleField& field)
{
  const auto location = PlaceInGrass(field);
  return [location, &field](const SunAt& sun, Cost& cost)
  {
    cost += location->Run("r.sunmask",
      { "-z", "elevation=heights", "output=shade", "altitude=" + std::to_string(sun.Elevation),
        "azimuth=" + std::to_string(sun.Azimuth), "--overwrite" });
    std::vector<float> lit = FromNorth(field, location->Take("shade"));
    for (float& value : lit)
    {
      value = value == 1.0f ? 0.0f : 1.0f; // 1 marks shadow
    }
    return lit;
  };
}

PeerSun GrassSun(const oracle::OracleField& field)
{
  const auto location = PlaceInGrass(field);
  ImportSlopes(*location, field);
  return [location, &field](const SunAt& sun, Cost& cost)
  {
    const double azimuth = sun.Azimuth * RadiansPerDegree;
    const double elevation = sun.Elevation * RadiansPerDegree;
    const double declination = std::asin(std::cos(elevation) * std::cos(azimuth));
    const double hour = std::atan2(-std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    constexpr double constant = 1000.0; // W/m2
    cost += location->Run("r.sun",
      { "elevation=heights", "slope=slope", "aspect=aspect", "beam_rad=beam", "linke_value=0",
        "solar_constant=" + std::to_string(constant), "day=" + std::to_string(Day), "nprocs=1",
        "declination=" + std::to_string(declination),
        "time=" + std::to_string(12.0 + 12.0 * hour / Pi), "--overwrite" });
    std::vector<float> beam = FromNorth(field, location->Take("beam"));
    // The distance from the sun on that day (Scharmer & Greif 2000), which changes the irradiance.
    const double distance = 1.0 + 0.03344 * std::cos(2.0 * Pi * Day / 365.25 - 0.048869);
    for (float& value : beam)
    {
      value = std::max(0.0f, value) / static_cast<float>(constant * distance); // Null is negative
    }
    return beam;
  };
}

std::vector<float> GrassDiffuse(const oracle::OracleField& field, Cost& cost)
{
  const auto location = PlaceInGrass(field);
  ImportSlopes(*location, field);
  location->Import("none", std::vector<double>(field.Heights.size(), 0.0));
  const auto run = [&](std::vector<std::string> slopes)
  {
    for (const char* word : { "elevation=heights", "coeff_bh=none", "diff_rad=diffuse", "-p",
           "nprocs=1", "declination=0", "time=12", "--overwrite" })
    {
      slopes.emplace_back(word);
    }
    slopes.push_back("day=" + std::to_string(Day));
    cost += location->Run("r.sun", slopes);
    return FromNorth(field, location->Take("diffuse"));
  };
  std::vector<float> tilted = run({ "slope=slope", "aspect=aspect" });
  const Cost before = cost;
  const std::vector<float> level = run({ "slope_value=0" }); // light of a level surface
  cost = before;
  for (std::size_t post = 0; post < tilted.size(); ++post)
  {
    tilted[post] /= level[post];
  }
  return tilted;
}

} // namespace benchmark
} // namespace skyline
