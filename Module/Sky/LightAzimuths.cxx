// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/LightAzimuths.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace skyline
{

namespace
{

/// Largest share of the light of a map in one interval, as a multiple of an even share.
constexpr double LargestShare = 2.0;

/// Intervals up to this width, in pixels, are not halved: the horizon hardly bends inside one.
constexpr double LeastPart = 0.125;

/// The light of a map from south to the left edge of each column, divided by that of all columns.
class LightByAzimuth
{
public:
  explicit LightByAzimuth(const TurnedLightMap& light)
    : Rotation(light.Rotation)
    , Sums(static_cast<std::size_t>(light.Map.Columns) + 1, 0.0)
  {
    const LightMap& map = light.Map;
    std::vector<double> columns(static_cast<std::size_t>(map.Columns), 0.0);
    for (std::ptrdiff_t row = 0; row < (map.Rows + 1) / 2; ++row)
    {
      // cos e (sin e + cos e): on a level plane plus on a vertical one that faces the light.
      const double zenith = Pi * (static_cast<double>(row) + 0.5) / static_cast<double>(map.Rows);
      const double weight = std::sin(zenith) * (std::cos(zenith) + std::sin(zenith));
      const float* pixel = map.Pixel(row, 0);
      for (double& sum : columns)
      {
        sum += weight * (static_cast<double>(pixel[0]) + pixel[1] + pixel[2]);
        pixel += 3;
      }
    }
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      this->Sums[c + 1] = this->Sums[c] + columns[c];
    }
  }

  double PixelWidth() const { return 2.0 * Pi / static_cast<double>(this->Sums.size() - 1); }

  /// The share of the light from the azimuths [begin, end), at most a full turn.
  double Share(double begin, double end) const
  {
    return this->Sums.back() > 0.0 ? (this->Until(end) - this->Until(begin)) / this->Sums.back()
                                   : 0.0;
  }

private:
  double Until(double azimuth) const
  {
    const double turns = (azimuth - this->Rotation) / (2.0 * Pi) + 0.5;
    const double place = (turns - std::floor(turns)) * static_cast<double>(this->Sums.size() - 1);
    const auto column = std::min(static_cast<std::size_t>(place), this->Sums.size() - 2);
    return std::floor(turns) * this->Sums.back() + this->Sums[column] +
      (place - static_cast<double>(column)) * (this->Sums[column + 1] - this->Sums[column]);
  }

  double Rotation;
  std::vector<double> Sums;
};

void AddInterval(const std::vector<LightByAzimuth>& lights, double largest, double begin,
  double end, std::vector<double>& azimuths)
{
  for (const LightByAzimuth& light : lights)
  {
    if (end - begin > LeastPart * light.PixelWidth() && light.Share(begin, end) > largest)
    {
      const double middle = 0.5 * (begin + end);
      AddInterval(lights, largest, begin, middle, azimuths);
      AddInterval(lights, largest, middle, end, azimuths);
      return;
    }
  }
  azimuths.push_back(begin);
}

} // namespace

std::vector<double> LightAzimuths(int count, const std::vector<TurnedLightMap>& maps, bool refine)
{
  std::vector<LightByAzimuth> lights;
  for (std::size_t m = 0; refine && m < maps.size(); ++m)
  {
    lights.emplace_back(maps[m]);
  }
  std::vector<double> azimuths;
  for (int k = 0; k < count; ++k)
  {
    AddInterval(
      lights, LargestShare / count, 2.0 * Pi * k / count, 2.0 * Pi * (k + 1) / count, azimuths);
  }
  return azimuths;
}

} // namespace skyline
