// SPDX-License-Identifier: BSD-3-Clause
#include "SkyImage.h"

#include "Shared/Constants.h"
#include "Sky/LightTable.h"
#include "Sky/ZonalSky.h"

#include "vtkSkylineEnvironmentLight.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

using skyline::Rgb;
using skyline::SkyImage;

/// The number of the uniform sky in CIE S 011.
constexpr int UniformType = 5;

SkyImage Blank(std::ptrdiff_t columns, std::ptrdiff_t rows)
{
  SkyImage sky;
  sky.Columns = columns;
  sky.Rows = rows;
  sky.Values.resize(static_cast<std::size_t>(3 * columns * rows), 0.0f);
  return sky;
}

// The sine of the elevation in the middle of a row.
double SineOf(std::ptrdiff_t row, std::ptrdiff_t rows)
{
  return std::cos(skyline::Pi * (static_cast<double>(row) + 0.5) / static_cast<double>(rows));
}

// Each row has the radiance for its elevation, relative to irradiance / pi on open level ground.
SkyImage Zonal(const skyline::SkyDescription& description, const Rgb& level)
{
  const int type = description.Kind == skyline::SkyKind::Zonal ? description.CieType : UniformType;
  SkyImage sky = Blank(2, skyline::FormulaColumns / 2);
  const std::ptrdiff_t half = sky.Rows / 2;
  double mean = 0.0;
  double weights = 0.0;
  std::vector<double> rows;
  for (std::ptrdiff_t row = 0; row < half; ++row)
  {
    const double sine = SineOf(row, sky.Rows);
    const double weight = sine * std::sqrt(1.0 - sine * sine);
    rows.push_back(skyline::ZonalSky::Radiance(type, sine));
    mean += weight * rows.back();
    weights += weight;
  }
  float* to = sky.Values.data();
  for (std::ptrdiff_t row = 0; row < half; ++row)
  {
    const double share = rows[static_cast<std::size_t>(row)] * weights / mean;
    for (int pixel = 0; pixel < 2; ++pixel)
    {
      for (const float channel : level)
      {
        *to++ = static_cast<float>(share * channel);
      }
    }
  }
  return sky;
}

// The map with its factors, reduced by averaging blocks of pixels.
SkyImage Mapped(const skyline::TurnedLightMap& light, std::ptrdiff_t most)
{
  const std::ptrdiff_t block = (light.Map.Columns + most - 1) / most;
  SkyImage sky = Blank(std::max<std::ptrdiff_t>(light.Map.Columns / block, 1),
    std::max<std::ptrdiff_t>(light.Map.Rows / block, 1));
  float* to = sky.Values.data();
  for (std::ptrdiff_t row = 0; row < sky.Rows; ++row)
  {
    const std::ptrdiff_t top = row * light.Map.Rows / sky.Rows;
    const std::ptrdiff_t bottom = std::max(top + 1, (row + 1) * light.Map.Rows / sky.Rows);
    for (std::ptrdiff_t column = 0; column < sky.Columns; ++column)
    {
      const std::ptrdiff_t left = column * light.Map.Columns / sky.Columns;
      const std::ptrdiff_t right =
        std::max(left + 1, (column + 1) * light.Map.Columns / sky.Columns);
      double sum[3] = { 0.0, 0.0, 0.0 };
      for (std::ptrdiff_t j = top; j < bottom; ++j)
      {
        for (std::ptrdiff_t i = left; i < right; ++i)
        {
          const float* pixel = light.Map.Pixel(j, i);
          for (int c = 0; c < 3; ++c)
          {
            sum[c] += pixel[c];
          }
        }
      }
      const auto pixels = static_cast<double>((bottom - top) * (right - left));
      for (int c = 0; c < 3; ++c)
      {
        *to++ = static_cast<float>(light.Scale[c] * sum[c] / pixels);
      }
    }
  }
  return sky;
}

// The typical luminance. Each row counts by its solid angle; 0 if everything is dark.
float TypicalOf(const SkyImage& sky)
{
  double sum = 0.0;
  double weights = 0.0;
  for (std::ptrdiff_t row = 0; row < sky.Rows / 2; ++row)
  {
    const double sine = SineOf(row, sky.Rows);
    const double weight = std::sqrt(1.0 - sine * sine);
    for (std::ptrdiff_t column = 0; column < sky.Columns; ++column)
    {
      const float* c = sky.Values.data() + 3 * (row * sky.Columns + column);
      const float luminance = skyline::Luminance({ { c[0], c[1], c[2] } });
      if (luminance > 0.0f)
      {
        sum += weight * std::log(luminance);
        weights += weight;
      }
    }
  }
  return weights > 0.0 ? static_cast<float>(std::exp(sum / weights)) : 0.0f;
}

// Fills the rows below the horizon: from the row above the horizon to the plain.
void FillBelow(SkyImage& sky, const Rgb& ground)
{
  const std::ptrdiff_t half = sky.Rows / 2;
  const float* horizon = sky.Values.data() + 3 * (half - 1) * sky.Columns;
  for (std::ptrdiff_t row = half; row < sky.Rows; ++row)
  {
    const double depth = -SineOf(row, sky.Rows);
    const auto share = static_cast<float>(1.0 - std::exp(-depth / skyline::PlainDepth));
    float* to = sky.Values.data() + 3 * row * sky.Columns;
    for (std::ptrdiff_t k = 0; k < 3 * sky.Columns; ++k)
    {
      const auto c = static_cast<std::size_t>(k % 3);
      const float plain = skyline::PlainAlbedo[c] * ground[c];
      to[k] = horizon[k] + share * (plain - horizon[k]);
    }
  }
}

} // namespace

namespace skyline
{

float SkyImage::Peak() const
{
  return this->Values.empty() ? 0.0f : *std::max_element(this->Values.begin(), this->Values.end());
}

SkyImage MakeSkyImage(const TerrainLight& light, const Rgb& level, const Rgb& ground)
{
  const SkyKind kind = light.Sky.Kind;
  SkyImage sky;
  if (kind == SkyKind::Uniform || kind == SkyKind::Zonal)
  {
    sky = Zonal(light.Sky, level);
    FillBelow(sky, ground);
  }
  else if (kind == SkyKind::None)
  {
    sky = Blank(2, 2);
  }
  else
  {
    vtkSkylineEnvironmentLight* map = light.Environment;
    const bool image = map->GetSource() == vtkSkylineEnvironmentLight::IMAGE;
    sky = Mapped(map->GetLightMap(), image ? MostMapColumns : FormulaColumns);
    if (!image)
    {
      FillBelow(sky, ground);
    }
  }
  sky.Typical = TypicalOf(sky);
  return sky;
}

std::string SkyImageKey(const TerrainLight& light, const Rgb& level, const Rgb& ground)
{
  std::ostringstream key;
  key.precision(9);
  key << light.Sky.Text;
  for (const Rgb& part : { level, light.Sky.Measured() ? level : ground })
  {
    key << '|' << part[0] << ',' << part[1] << ',' << part[2];
  }
  if (light.Environment)
  {
    key << '|' << light.Environment->GetSunAzimuth() << ',' << light.Environment->GetSunElevation()
        << ',' << light.Environment->GetRadiance()[0];
  }
  return key.str();
}

} // namespace skyline
