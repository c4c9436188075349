// SPDX-License-Identifier: BSD-3-Clause
#include "Truth.h"

#include "Shapes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace skyline
{
namespace benchmark
{

Truth::Truth(const Scene& scene, std::ptrdiff_t posts, std::vector<double> azimuths,
  std::uint64_t seed)
  : Azimuths(std::move(azimuths))
{
  const oracle::OracleField& field = scene.Field;
  if (std::none_of(field.Heights.begin(), field.Heights.end(),
        [](double height) { return std::isfinite(height); }))
  {
    throw std::runtime_error("the scene " + scene.Name + " has no posts");
  }
  shapes::Random random(seed);
  while (static_cast<std::ptrdiff_t>(this->Posts.size()) < posts)
  {
    const std::ptrdiff_t post = random.Below(field.Columns * field.Rows);
    if (std::isfinite(field.Heights[static_cast<std::size_t>(post)]))
    {
      this->Posts.push_back(post);
    }
  }
  this->Elevations.reserve(this->Azimuths.size() * this->Posts.size());
  for (const double azimuth : this->Azimuths)
  {
    const oracle::Direction direction = oracle::DirectionOfAzimuth(azimuth);
    for (const std::ptrdiff_t post : this->Posts)
    {
      const double slope =
        oracle::HorizonSlope(field, post % field.Columns, post / field.Columns, direction);
      this->Elevations.push_back(oracle::ElevationDegrees(slope));
    }
  }
}

Errors ErrorSum::Get() const
{
  Errors errors;
  const std::size_t count = this->Differences.size();
  errors.Samples = static_cast<double>(count);
  if (count == 0)
  {
    return errors;
  }
  double sum = 0.0;
  double squares = 0.0;
  std::vector<double> sizes;
  sizes.reserve(count);
  for (const double difference : this->Differences)
  {
    sum += difference;
    squares += difference * difference;
    sizes.push_back(std::abs(difference));
  }
  std::sort(sizes.begin(), sizes.end());
  const auto rank = static_cast<std::size_t>(std::ceil(0.999 * static_cast<double>(count)));
  errors.Bias = sum / static_cast<double>(count);
  errors.Rmse = std::sqrt(squares / static_cast<double>(count));
  errors.Percentile999 = sizes[rank - 1];
  errors.Largest = sizes.back();
  return errors;
}

} // namespace benchmark
} // namespace skyline
