// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceHorizons.h"

#include "Reference/Shapes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace skyline
{
namespace benchmark
{

namespace
{

bool HasFourCells(const oracle::OracleField& field, std::ptrdiff_t column, std::ptrdiff_t row)
{
  return field.HasCell(column - 1, row - 1) && field.HasCell(column, row - 1) &&
    field.HasCell(column - 1, row) && field.HasCell(column, row);
}

} // namespace

ReferenceHorizons::ReferenceHorizons(const Scene& scene, std::ptrdiff_t posts,
  std::vector<double> azimuths, std::uint64_t seed, const WantsToStop& stop)
  : Azimuths(std::move(azimuths))
{
  const oracle::OracleField& field = scene.Field;
  std::vector<std::ptrdiff_t> inside;
  for (std::ptrdiff_t post = 0; post < field.Columns * field.Rows; ++post)
  {
    if (HasFourCells(field, post % field.Columns, post / field.Columns))
    {
      inside.push_back(post);
    }
  }
  if (inside.empty())
  {
    throw std::runtime_error("the scene " + scene.Name + " has no post with four cells around it");
  }
  shapes::Random random(seed);
  for (std::ptrdiff_t k = 0; k < posts; ++k)
  {
    const std::ptrdiff_t drawn = random.Below(static_cast<std::ptrdiff_t>(inside.size()));
    this->Posts.push_back(inside[static_cast<std::size_t>(drawn)]);
  }
  this->Find(field, stop);
}

ReferenceHorizons::ReferenceHorizons(const Scene& scene, std::vector<std::ptrdiff_t> posts,
  std::vector<double> azimuths, const WantsToStop& stop)
  : Azimuths(std::move(azimuths))
  , Posts(std::move(posts))
{
  this->Find(scene.Field, stop);
}

void ReferenceHorizons::Find(const oracle::OracleField& field, const WantsToStop& stop)
{
  const std::size_t count = this->Posts.size();
  this->Elevations.resize(this->Azimuths.size() * count);
  constexpr std::size_t part = 64; // number of posts in one piece of work
  const std::size_t parts = (count + part - 1) / part;
  ForAll(
    this->Azimuths.size() * parts,
    [&](std::size_t work)
    {
      const std::size_t azimuth = work / parts;
      const oracle::Direction direction = oracle::DirectionOfAzimuth(this->Azimuths[azimuth]);
      for (std::size_t i = work % parts * part; i < std::min(count, (work % parts + 1) * part); ++i)
      {
        const std::ptrdiff_t post = this->Posts[i];
        this->Elevations[azimuth * count + i] = oracle::ElevationDegrees(
          oracle::HorizonSlope(field, post % field.Columns, post / field.Columns, direction));
      }
    },
    stop);
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
