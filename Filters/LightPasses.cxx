// SPDX-License-Identifier: BSD-3-Clause
#include "LightPasses.h"

#include "HorizonDriver.h"
#include "Lamps/LampIrradiance.h"
#include "PlacedSun.h"
#include "Sun/SunAccumulator.h"
#include "vtkSkylineKeyLight.h"
#include "vtkSkylineLampLight.h"
#include "vtkSkylineSunLight.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

namespace skyline
{

namespace
{

/// Rows that one thread takes between two checks of the abort flag.
constexpr std::ptrdiff_t RowsPerStrip = 64;

std::string Text(double number)
{
  std::string text = std::to_string(number);
  text.erase(text.find_last_not_of('0') + 1);
  return text.back() == '.' ? text + "0" : text;
}

void Check(bool fine, const char* light, const char* what, double value, const char* range)
{
  if (!fine)
  {
    throw std::invalid_argument(
      std::string(light) + ": " + what + " " + Text(value) + " is out of range: " + range);
  }
}

void CheckColor(const char* light, const double* color)
{
  for (int c = 0; c < 3; ++c)
  {
    Check(color[c] >= 0.0 && std::isfinite(color[c]), light, "colour", color[c], "0 or more");
  }
}

/// The part of the area of a disc that lies above a plane. The centre stands above the plane by the
/// angle whose sine is `height` times that of the radius of the disc.
double PartAbove(double height)
{
  const double x = std::clamp(height, -1.0, 1.0);
  return 0.5 + (std::asin(x) + x * std::sqrt((1.0 - x) * (1.0 + x))) / Pi;
}

/// Adds the light of a disc, of which the lit part is known for each post. directions(row, x, y, z,
/// left) writes unit vectors to its centre for a row of posts; into `left` it writes the share of
/// its light that shines, if that is not 1.
template <typename Directions>
void AddLitDisc(const Grid& grid, const LitPosts& posts, const float* lit, double radius,
  const std::array<double, 3>& irradiance, const Directions& directions)
{
  const LampDisc disc{ std::sin(radius), std::cos(radius) };
  const double facing = radius > 0.0 ? DiscIrradiance(disc, 1.0) : 1.0;
  vtkSMPTools::For(0, grid.Rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<float> vectors(static_cast<std::size_t>(4 * grid.Columns), 1.0f);
      float* x = vectors.data();
      float* y = x + grid.Columns;
      float* z = y + grid.Columns;
      float* left = z + grid.Columns;
      for (vtkIdType row = begin; row < end; ++row)
      {
        directions(row, x, y, z, left);
        for (std::ptrdiff_t column = 0; column < grid.Columns; ++column)
        {
          const std::ptrdiff_t post = row * grid.Columns + column;
          const double east = posts.East ? posts.East[post] : 0.0;
          const double north = posts.East ? posts.North[post] : 0.0;
          const double cosine = (z[column] - east * x[column] - north * y[column]) /
            std::sqrt(1.0 + east * east + north * north);
          double light = 0.0;
          if (radius > 0.0)
          {
            // The part above the horizon may lie above the plane of the post or below it. Where
            // both cut the disc, they are mostly the same ground, so only the shadow beyond that of
            // the plane counts.
            const double above = PartAbove(cosine / disc.Sine);
            const double part = above > 0.0 ? std::min(1.0, lit[post] / above) : 0.0;
            light = left[column] * part * DiscIrradiance(disc, cosine) / facing;
          }
          else
          {
            light = left[column] * lit[post] * std::max(0.0, cosine);
          }
          for (std::size_t c = 0; c < 3; ++c)
          {
            posts.Irradiance[3 * post + static_cast<std::ptrdiff_t>(c)] +=
              static_cast<float>(irradiance[c] * light);
          }
        }
      }
    });
}

} // namespace

SkyDisc DiscOf(vtkSkylineSunLight* light)
{
  SkyDisc disc;
  Check(std::isfinite(light->GetAzimuth()), "sun", "azimuth", light->GetAzimuth(), "any angle");
  Check(std::abs(light->GetElevation()) <= 90.0, "sun", "elevation", light->GetElevation(),
    "-90 to 90 degrees");
  const double radius = light->GetAngularRadius();
  Check(radius >= 0.0 && radius <= LargestSun * DegreesPerRadian, "sun", "angular radius", radius,
    "0 to 3 degrees; larger discs are key lights");
  CheckColor("sun", light->GetIrradiance());
  disc.Azimuth = std::fmod(light->GetAzimuth(), 360.0) * RadiansPerDegree;
  disc.Elevation = light->GetElevation() * RadiansPerDegree;
  disc.Radius = radius * RadiansPerDegree;
  std::copy_n(light->GetIrradiance(), 3, disc.Irradiance.begin());
  return disc;
}

SkyDisc DiscOf(vtkSkylineSunLight* light, const HorizonDriver& driver)
{
  SkyDisc disc = DiscOf(light);
  if (light->GetUseTime())
  {
    const SunField sun = SunFieldOf(light, driver.Input().Place(), driver.Input().BaseHeight());
    const GridSun middle = InTheMiddle(sun, driver.Input().Place());
    disc.Azimuth = middle.Azimuth * RadiansPerDegree;
    disc.Elevation = middle.Elevation * RadiansPerDegree;
    disc.Radius = RadiusOf(light, sun) * RadiansPerDegree;
    const EclipseField eclipse =
      EclipseFieldOf(light, driver.Input().Place(), driver.Input().BaseHeight());
    if (eclipse.Any())
    {
      const double covered =
        InTheMiddle(eclipse, driver.Input().Place()).Obscuration(LimbDarkeningOf(light));
      for (double& channel : disc.Irradiance)
      {
        channel *= 1.0 - covered;
      }
    }
    return disc;
  }
  return InMiddle(disc, driver);
}

SkyDisc InMiddle(SkyDisc disc, const HorizonDriver& driver)
{
  const SunField field = SunField::OnImage(driver.Input().Place(), disc.Azimuth * DegreesPerRadian,
    disc.Elevation * DegreesPerRadian, disc.Radius * DegreesPerRadian);
  if (!field.Same())
  {
    disc.Azimuth = InTheMiddle(field, driver.Input().Place()).Azimuth * RadiansPerDegree;
  }
  return disc;
}

SkyDisc DiscOf(vtkSkylineKeyLight* light)
{
  SkyDisc disc;
  Check(
    std::isfinite(light->GetAzimuth()), "key light", "azimuth", light->GetAzimuth(), "any angle");
  Check(std::abs(light->GetElevation()) <= 90.0, "key light", "elevation", light->GetElevation(),
    "-90 to 90 degrees");
  const double radius = light->GetAngularRadius();
  Check(radius > 0.0 && radius < 90.0, "key light", "angular radius", radius,
    "above 0 to below 90 degrees");
  CheckColor("key light", light->GetRadiance());
  disc.Azimuth = std::fmod(light->GetAzimuth(), 360.0) * RadiansPerDegree;
  disc.Elevation = light->GetElevation() * RadiansPerDegree;
  disc.Radius = radius * RadiansPerDegree;
  const double reach = std::sin(disc.Radius);
  for (std::size_t c = 0; c < 3; ++c)
  {
    disc.Irradiance[c] = Pi * reach * reach * light->GetRadiance()[c];
  }
  return disc;
}

std::vector<float> DrawDisc(const SkyDisc& disc, int& columns, int& rows)
{
  constexpr int SamplesPerSide = 4; // samples per side that tell how much of a pixel is inside
  rows = 2 * static_cast<int>(std::ceil(0.5 * Pi / (disc.Radius / 16.0)));
  rows = std::max(rows, 180);
  columns = 2 * rows;
  std::vector<float> pixels(static_cast<std::size_t>(3 * columns) * static_cast<std::size_t>(rows));
  const double limit = std::cos(disc.Radius);
  const double sine = std::sin(disc.Elevation), cosine = std::cos(disc.Elevation);
  const double step = Pi / rows;
  const double reach = std::sin(disc.Radius);
  for (int row = 0; row < rows; ++row)
  {
    if (std::abs(0.5 * Pi - (row + 0.5) * step - disc.Elevation) > disc.Radius + step)
    {
      continue;
    }
    for (int column = 0; column < columns; ++column)
    {
      int inside = 0;
      for (int u = 0; u < SamplesPerSide; ++u)
      {
        const double zenith = (row + (u + 0.5) / SamplesPerSide) * step;
        for (int v = 0; v < SamplesPerSide; ++v)
        {
          const double azimuth = (column + (v + 0.5) / SamplesPerSide) * step - Pi;
          inside +=
            std::cos(zenith) * sine + std::sin(zenith) * cosine * std::cos(azimuth - disc.Azimuth) >
              limit
            ? 1
            : 0;
        }
      }
      for (std::size_t c = 0; c < 3 && inside > 0; ++c)
      {
        pixels[3 *
            (static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
              static_cast<std::size_t>(column)) +
          c] = static_cast<float>(disc.Irradiance[c] / (Pi * reach * reach) * inside /
          (SamplesPerSide * SamplesPerSide));
      }
    }
  }
  return pixels;
}

bool AddDisc(HorizonDriver& driver, HorizonCache& cache, const SkyDisc& disc, const LitPosts& posts)
{
  if (disc.Elevation + disc.Radius <= 0.0)
  {
    return true; // below the horizon: no light, no search
  }
  const SunField field = SunField::OnImage(driver.Input().Place(), disc.Azimuth * DegreesPerRadian,
    disc.Elevation * DegreesPerRadian, disc.Radius * DegreesPerRadian);
  if (!field.Same())
  {
    return AddSun(driver, cache, field, EclipseField(), disc, 0.0, posts);
  }
  const Grid& grid = driver.Input().Posts();
  const std::vector<double> azimuths =
    SunAzimuths(disc.Azimuth, disc.Azimuth, disc.Elevation, disc.Elevation, disc.Radius);
  const std::unique_ptr<float[]> lit(new float[static_cast<std::size_t>(grid.Columns * grid.Rows)]);
  SunAccumulator sun(grid.Columns, grid.Rows, { disc.Azimuth, disc.Elevation, disc.Radius },
    PostBuffer{ lit.get(), 1 });
  if (!cache.Run(driver, azimuths, 0.0, sun))
  {
    return false;
  }
  const auto cosine = std::cos(disc.Elevation);
  const auto toX = static_cast<float>(cosine * std::sin(disc.Azimuth));
  const auto toY = static_cast<float>(cosine * std::cos(disc.Azimuth));
  const auto toZ = static_cast<float>(std::sin(disc.Elevation));
  AddLitDisc(grid, posts, lit.get(), disc.Radius, disc.Irradiance,
    [&](std::ptrdiff_t, float* x, float* y, float* z, float*)
    {
      std::fill_n(x, grid.Columns, toX);
      std::fill_n(y, grid.Columns, toY);
      std::fill_n(z, grid.Columns, toZ);
    });
  return true;
}

bool AddSun(
  HorizonDriver& driver, HorizonCache& cache, vtkSkylineSunLight* light, const LitPosts& posts)
{
  SkyDisc disc = DiscOf(light);
  const SunField sun = SunFieldOf(light, driver.Input().Place(), driver.Input().BaseHeight());
  const EclipseField eclipse =
    EclipseFieldOf(light, driver.Input().Place(), driver.Input().BaseHeight());
  disc.Radius = RadiusOf(light, sun) * RadiansPerDegree;
  const double darkening = LimbDarkeningOf(light);
  return AddSun(driver, cache, sun, eclipse, disc, darkening, posts);
}

bool AddSun(HorizonDriver& driver, HorizonCache& cache, const SunField& sun,
  const EclipseField& eclipse, const SkyDisc& disc, double darkening, const LitPosts& posts)
{
  double first = 0.0, last = 0.0, least = 0.0, greatest = 0.0;
  sun.AzimuthBounds(first, last);
  sun.ElevationBounds(least, greatest);
  if (greatest * RadiansPerDegree + disc.Radius <= 0.0)
  {
    return true; // below the horizon for all posts
  }
  const std::vector<double> azimuths = SunAzimuths(first * RadiansPerDegree,
    last * RadiansPerDegree, least * RadiansPerDegree, greatest * RadiansPerDegree, disc.Radius);
  const Grid& grid = driver.Input().Posts();
  const std::unique_ptr<float[]> lit(new float[static_cast<std::size_t>(grid.Columns * grid.Rows)]);
  const PostBuffer buffer{ lit.get(), 1 };
  const auto row = [&](std::ptrdiff_t number, std::ptrdiff_t column, std::ptrdiff_t count, float* x,
                     float* y, float* z) { sun.Row(number, column, count, x, y, z); };
  const auto run = [&](SunAccumulator&& visibility)
  { return cache.Run(driver, azimuths, 0.0, visibility); };
  const bool finished = !sun.Same()
    ? run(SunAccumulator(grid.Columns, grid.Rows, row, disc.Radius, buffer, darkening))
    : run(SunAccumulator(grid.Columns, grid.Rows,
        SunDisc{ disc.Azimuth, disc.Elevation, disc.Radius }, buffer, darkening));
  if (finished)
  {
    AddLitDisc(grid, posts, lit.get(), disc.Radius, disc.Irradiance,
      [&](std::ptrdiff_t number, float* x, float* y, float* z, float* left)
      {
        sun.Row(number, 0, grid.Columns, x, y, z);
        if (eclipse.Any())
        {
          eclipse.Uncovered(number, 0, grid.Columns, darkening, left);
        }
      });
  }
  return finished;
}

bool AddLamp(
  HorizonDriver& driver, const ImageFrame& image, vtkSkylineLampLight* light, const LitPosts& posts)
{
  const LampTerrain terrain(driver.Input().Field());
  LampSettings settings;
  settings.Shape = driver.UsedSettings().Shape;
  settings.CurvatureDrop = driver.UsedSettings().CurvatureDrop;
  const Grid& posted = driver.Input().Posts();
  const double column = (light->GetPosition()[0] - image.Origin[0]) / image.Spacing[0];
  const double row = (light->GetPosition()[1] - image.Origin[1]) / image.Spacing[1];
  // Lamps ignore shear: they use the steps at the centre, at right angles.
  driver.DoubtOneMetric("lamps", { posted.SpacingX, 0.0, posted.SpacingY });
  const double rows = static_cast<double>(posted.Rows);
  for (const RowBand& band : driver.Input().Bands())
  {
    const Grid grid = WithSpacing(posted, band);
    Lamp lamp;
    lamp.X = column * grid.SpacingX;
    lamp.Y = row * grid.SpacingY;
    lamp.Z = light->GetPosition()[2] - driver.Input().BaseHeight();
    lamp.Radius = light->GetRadius();
    for (std::size_t c = 0; c < 3; ++c)
    {
      lamp.Radiance[c] = static_cast<float>(light->GetRadiance()[c]);
    }
    CheckLamp(lamp); // not in a thread, where exceptions must not be thrown
    for (std::ptrdiff_t begin = band.RowBegin; begin < band.RowEnd; begin += RowsPerStrip)
    {
      if (driver.Progress && !driver.Progress(static_cast<double>(begin) / rows))
      {
        return false;
      }
      vtkSMPTools::For(begin, std::min(begin + RowsPerStrip, band.RowEnd),
        [&](vtkIdType from, vtkIdType to)
        {
          AddLampIrradiance(
            terrain, grid, posts.East, posts.North, lamp, settings, from, to, posts.Irradiance);
        });
    }
  }
  return true;
}

} // namespace skyline
