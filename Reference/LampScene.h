// SPDX-License-Identifier: BSD-3-Clause
// Computes the light of a lamp over a field of the oracle.
#ifndef skyline_LampScene_h
#define skyline_LampScene_h

#include "HeightField/Normals.h"
#include "Lamps/LampIrradiance.h"
#include "Reference/LampOracle.h"
#include "Reference/OracleTerrain.h"

#include <cstddef>
#include <vector>

namespace skyline
{
namespace testing
{

/// A field, and a lamp whose height is given in the heights of the field.
class LampScene
{
public:
  LampScene(const oracle::OracleField& field)
    : Heights(field)
    , Field(FieldOf(field))
    , Terrain(Field)
    , Posts(GridOf(field))
    , East(static_cast<std::size_t>(Posts.Columns * Posts.Rows))
    , North(East.size())
  {
    this->Settings.Shape = field.Through;
    this->Settings.CurvatureDrop = field.CurvatureDrop;
    Gradients(
      this->Posts, [&](std::ptrdiff_t i, std::ptrdiff_t j) { return field.At(i, j); }, 0,
      this->Posts.Rows, this->East.data(), this->North.data());
  }

  /// The first colour band of the irradiance of all posts. level: whether all receivers are
  /// horizontal.
  std::vector<float> Light(const oracle::Ball& ball, bool level = false) const
  {
    Lamp lamp;
    lamp.X = ball.Centre.X;
    lamp.Y = ball.Centre.Y;
    lamp.Z = ball.Centre.Z - BaseOf(this->Heights);
    lamp.Radius = ball.Radius;
    std::vector<float> rgb(3 * this->East.size(), 0.0f);
    AddLampIrradiance(this->Terrain, this->Posts, level ? nullptr : this->East.data(),
      level ? nullptr : this->North.data(), lamp, this->Settings, 0, this->Posts.Rows, rgb.data());
    std::vector<float> light(this->East.size());
    for (std::size_t k = 0; k < light.size(); ++k)
    {
      light[k] = rgb[3 * k];
    }
    return light;
  }

  oracle::Vector3 Normal(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    const std::size_t post = this->Heights.Index(column, row);
    return oracle::Unit({ -this->East[post], -this->North[post], 1.0 });
  }

  /// The irradiance of a post without any terrain in the way, by the closed form.
  double Unshadowed(const oracle::Ball& ball, std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    const oracle::Vector3 to = ball.Centre - oracle::PlaceOf(this->Heights, column, row);
    const double distance = std::sqrt(oracle::Dot(to, to));
    const double cosine =
      distance > 0.0 ? oracle::Dot(to, this->Normal(column, row)) / distance : 1.0;
    return DiscIrradiance(DiscOfLamp(ball.Radius, distance), cosine);
  }

  oracle::OracleField Heights;
  HeightField Field;
  LampTerrain Terrain;
  Grid Posts;
  LampSettings Settings;
  std::vector<float> East, North;
};

} // namespace testing
} // namespace skyline

#endif
