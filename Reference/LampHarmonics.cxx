// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/LampHarmonics.h"

#include "Harmonics/HarmonicProduct.h"
#include "Harmonics/VisibilityAccumulator.h"
#include "Horizon/RayFrame.h"
#include "Lamps/LampWalk.h"
#include "Reference/LampPyramid.h"
#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace skyline
{

namespace
{

/// Number of rows whose coefficients are in memory at once.
constexpr std::ptrdiff_t RowsAtATime = 8;

/// If the sine of its angular radius is below this value, a disc is treated as a point with the
/// same solid angle. With 8 bands the error is at most l (l + 1) s^2 / 8 = 7e-8.
constexpr double PointSine = 1.0e-4;

/// Finds the greatest slope up to a distance. This is the visitor of a LampWalk.
struct NearHorizon
{
  double Distance;
  double Slope = -std::numeric_limits<double>::infinity();

  double End() const { return this->Distance; }
  double Fine() const { return std::numeric_limits<double>::infinity(); }
  double Threshold() const { return this->Slope; }
  void Start(double slope) { this->Slope = std::max(this->Slope, slope); }
  bool Piece(double s0, double z0, double s1, double z1)
  {
    const bool last = s1 >= this->Distance;
    const double s = last ? this->Distance : s1;
    const double z = last ? z0 + (z1 - z0) * (s - s0) / (s1 - s0) : z1;
    if (s0 > 0.0)
    {
      this->Slope = std::max(this->Slope, z0 / s0);
    }
    this->Slope = std::max(this->Slope, z / s);
    return !last;
  }
};

/// The heights of the receivers of a row, including posts without a complete cell.
class Receivers
{
public:
  explicit Receivers(const HeightField& field)
    : Field(field)
  {
  }
  const float* Row(std::ptrdiff_t row) { return this->Field.Receivers(false, row, this->Buffer); }

private:
  const HeightField& Field;
  std::vector<float> Buffer;
};

void Check(const LampHarmonicSettings& settings)
{
  if (settings.Bands < 2 || settings.Bands > MaxHarmonicBands)
  {
    throw std::invalid_argument("lamp: " + std::to_string(settings.Bands) + " bands; give 2 to 8");
  }
  if (settings.Azimuths < 1)
  {
    throw std::invalid_argument(
      "lamp: " + std::to_string(settings.Azimuths) + " azimuths; give 1 or more");
  }
}

} // namespace

void LampZonal(int bands, const LampDisc& disc, double* zonal)
{
  const bool point = disc.Cosine > 0.0 && disc.Sine < PointSine;
  const double solid = 2.0 * Pi * disc.Sine * disc.Sine / (1.0 + disc.Cosine);
  for (int l = 0; l < bands; ++l)
  {
    zonal[l] = point ? std::sqrt((2.0 * l + 1.0) / (4.0 * Pi)) * solid : CapZonal(l, disc.Cosine);
  }
}

void FindLampHorizons(const LampTerrain& terrain, const Grid& grid, Surface shape, double drop,
  const Lamp& lamp, double azimuth, std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, float* slopes)
{
  const LampWalk walk(terrain, grid, shape, drop);
  const Direction direction = DirectionOfAzimuth(azimuth);
  const LampAzimuth along{ direction.East, direction.North };
  Receivers receivers(terrain.Field());
  for (std::ptrdiff_t row = rowBegin; row < rowEnd; ++row)
  {
    const float* heights = receivers.Row(row);
    const double y = lamp.Y - static_cast<double>(row) * grid.SpacingY;
    for (std::ptrdiff_t column = 0; column < grid.Columns; ++column)
    {
      const double x = lamp.X - static_cast<double>(column) * grid.SpacingX;
      NearHorizon horizon{ std::max(std::hypot(x, y), std::numeric_limits<double>::min()) };
      const LampReceiver post{ column, row, static_cast<double>(heights[column]) };
      if (heights[column] > 0.5f * MissingHeight)
      {
        walk(post, along, horizon);
      }
      slopes[(row - rowBegin) * grid.Columns + column] =
        static_cast<float>(std::max(horizon.Slope, static_cast<double>(NoTerrainSlope)));
    }
  }
}

void AddLampHarmonics(const LampTerrain& terrain, const Grid& grid, const float* east,
  const float* north, const Lamp& lamp, const LampHarmonicSettings& settings,
  std::ptrdiff_t rowBegin, std::ptrdiff_t rowEnd, float* rgb)
{
  CheckLamp(lamp);
  Check(settings);
  const std::ptrdiff_t columns = grid.Columns;
  const int bands = settings.Bands, count = HarmonicCount(bands);
  const bool transfer = settings.Product == LampProduct::Transfer;
  const HarmonicProduct& product = HarmonicProduct::ForBands(bands);
  const auto rowFloats = static_cast<std::size_t>(RowsAtATime * columns);
  std::vector<float> values(rowFloats * static_cast<std::size_t>(count)), slopes(rowFloats);
  const std::vector<float> level(east ? 0 : rowFloats, 0.0f);
  double cosineZonal[MaxHarmonicBands];
  for (int l = 0; l < bands; ++l)
  {
    cosineZonal[l] = ClampedCosineZonal(l);
  }
  Receivers receivers(terrain.Field());

  for (std::ptrdiff_t begin = rowBegin; begin < rowEnd; begin += RowsAtATime)
  {
    const std::ptrdiff_t end = std::min(begin + RowsAtATime, rowEnd);
    const float* slopeEast = east ? east + begin * columns : level.data();
    const float* slopeNorth = east ? north + begin * columns : level.data();
    const HarmonicBuffers buffers{ columns, end - begin, bands, values.data(), SkyPart::Sphere };
    VisibilityAccumulator visibility(
      buffers, transfer ? slopeEast : nullptr, transfer ? slopeNorth : nullptr);
    const double width = 2.0 * Pi / settings.Azimuths;
    for (int k = 0; k < settings.Azimuths; ++k)
    {
      if (settings.Pyramid)
      {
        FindLampHorizons(*settings.Pyramid, settings.Levels, grid, settings.CurvatureDrop, lamp,
          k * width, begin, end, slopes.data());
      }
      else
      {
        FindLampHorizons(terrain, grid, settings.Shape, settings.CurvatureDrop, lamp, k * width,
          begin, end, slopes.data());
      }
      visibility.Begin(k * width, width);
      for (std::ptrdiff_t row = 0; row < end - begin; ++row)
      {
        visibility.Add(row, 0, columns, slopes.data() + row * columns);
      }
    }
    visibility.Finish(0, end - begin);

    for (std::ptrdiff_t row = begin; row < end; ++row)
    {
      const float* heights = receivers.Row(row);
      const double y = lamp.Y - static_cast<double>(row) * grid.SpacingY;
      for (std::ptrdiff_t column = 0; column < columns; ++column)
      {
        const std::ptrdiff_t post = (row - begin) * columns + column;
        float* result = rgb + 3 * (row * columns + column);
        if (heights[column] <= 0.5f * MissingHeight)
        {
          std::fill_n(result, 3, std::numeric_limits<float>::quiet_NaN());
          continue;
        }
        const double x = lamp.X - static_cast<double>(column) * grid.SpacingX;
        const double square = x * x + y * y;
        const double z = lamp.Z - heights[column] - settings.CurvatureDrop * square;
        const double distance = std::sqrt(square + z * z);
        double zonal[MaxHarmonicBands];
        LampZonal(bands, DiscOfLamp(lamp.Radius, distance), zonal);
        float light[HarmonicCount(MaxHarmonicBands)], zonalLight[MaxHarmonicBands];
        std::transform(
          zonal, zonal + bands, zonalLight, [](double v) { return static_cast<float>(v); });
        const double toUnit = distance > 0.0 ? 1.0 / distance : 0.0;
        RotateZonal(bands, zonalLight, static_cast<float>(x * toUnit),
          static_cast<float>(y * toUnit), distance > 0.0 ? static_cast<float>(z * toUnit) : 1.0f,
          light);

        const float* seen = values.data() + post * count;
        float sum = 0.0f;
        if (transfer)
        {
          for (int k = 0; k < count; ++k)
          {
            sum += seen[k] * light[k];
          }
        }
        else
        {
          const float up = 1.0f /
            std::sqrt(
              1.0f + slopeEast[post] * slopeEast[post] + slopeNorth[post] * slopeNorth[post]);
          float facing[HarmonicCount(MaxHarmonicBands)], zonalFacing[MaxHarmonicBands];
          std::transform(cosineZonal, cosineZonal + bands, zonalFacing,
            [](double v) { return static_cast<float>(v); });
          RotateZonal(
            bands, zonalFacing, -slopeEast[post] * up, -slopeNorth[post] * up, up, facing);
          // THESIS truncates the product of visibility and cosine before it multiplies by the
          // light. The result is the same, because the light has no coefficients in the truncated
          // bands.
          sum = product.TripleIntegral(seen, facing, light);
        }
        for (int band = 0; band < 3; ++band)
        {
          result[band] += std::max(0.0f, sum) * lamp.Radiance[static_cast<std::size_t>(band)];
        }
      }
    }
  }
}

} // namespace skyline
