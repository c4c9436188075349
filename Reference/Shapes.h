// SPDX-License-Identifier: BSD-3-Clause
// Height fields with known horizons, and rough ones without. They are the same on all machines. For
// tests only.
#ifndef skyline_Shapes_h
#define skyline_Shapes_h

#include "Reference/Oracle.h"

#include <cstdint>

namespace skyline
{
namespace shapes
{

using oracle::OracleField;

/// Uniform random numbers in [0, 1) from a seed: splitmix64 (Steele, Lea, Flood 2014).
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : State(seed)
  {
  }
  double operator()()
  {
    this->State += 0x9E3779B97F4A7C15ull;
    std::uint64_t z = this->State;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    z ^= z >> 31;
    return static_cast<double>(z >> 11) * 0x1p-53;
  }
  /// A random integer in [0, n).
  std::ptrdiff_t Below(std::ptrdiff_t n)
  {
    return static_cast<std::ptrdiff_t>((*this)() * static_cast<double>(n));
  }

private:
  std::uint64_t State;
};

/// A field whose heights are f(x, y), with x and y in metres east and north of the post
/// (centreColumn, centreRow).
template <class Function>
OracleField FromFunction(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacingX,
  double spacingY, std::ptrdiff_t centreColumn, std::ptrdiff_t centreRow, const Function& f)
{
  OracleField field(columns, rows, spacingX, spacingY);
  for (std::ptrdiff_t j = 0; j < rows; ++j)
  {
    for (std::ptrdiff_t i = 0; i < columns; ++i)
    {
      field.At(i, j) = f(static_cast<double>(i - centreColumn) * spacingX,
        static_cast<double>(j - centreRow) * spacingY);
    }
  }
  return field;
}

/// A plane z = eastSlope x + northSlope y, 0 at the middle post.
inline OracleField Plane(
  std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double eastSlope, double northSlope)
{
  return FromFunction(columns, rows, spacing, spacing, columns / 2, rows / 2,
    [=](double x, double y) { return eastSlope * x + northSlope * y; });
}

/// A valley z = slope |x| with its floor along the middle column. Exact at the posts.
inline OracleField Valley(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double slope)
{
  return FromFunction(columns, rows, spacing, spacing, columns / 2, rows / 2,
    [=](double x, double) { return slope * std::abs(x); });
}

/// A wall along the columns, which begins at 'column' and is 'thickness' posts wide (0: to the east
/// edge). Its foot is the column before.
inline OracleField Wall(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double height,
  std::ptrdiff_t column, std::ptrdiff_t thickness = 0)
{
  const std::ptrdiff_t end = thickness > 0 ? column + thickness : columns;
  return FromFunction(columns, rows, spacing, spacing, column, 0,
    [=](double x, double)
    {
      const double places = std::round(x / spacing);
      return places >= 0.0 && places < static_cast<double>(end - column) ? height : 0.0;
    });
}

/// A trench along the middle column: its floor has height 0 up to 'halfWidth' posts from the
/// middle, and all posts beyond have the height 'height'. The upper edges are (halfWidth + 1)
/// spacings from the middle.
inline OracleField Trench(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing,
  double height, std::ptrdiff_t halfWidth)
{
  return FromFunction(columns, rows, spacing, spacing, columns / 2, rows / 2,
    [=](double x, double)
    { return std::round(std::abs(x) / spacing) <= static_cast<double>(halfWidth) ? 0.0 : height; });
}

/// A cylindrical pit around the middle post: its floor lies at -depth where the distance is less
/// than 'radius'.
inline OracleField CylinderPit(
  std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double radius, double depth)
{
  return FromFunction(columns, rows, spacing, spacing, columns / 2, rows / 2,
    [=](double x, double y) { return std::hypot(x, y) < radius ? -depth : 0.0; });
}

/// A conical pit with its apex at the middle post, which rises with 'slope' to level ground at
/// 'radius'.
inline OracleField ConicalPit(
  std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double radius, double slope)
{
  return FromFunction(columns, rows, spacing, spacing, columns / 2, rows / 2,
    [=](double x, double y) { return slope * (std::min(std::hypot(x, y), radius) - radius); });
}

/// A spherical bowl around the middle post: the cap with the half-angle 'halfAngle' (radians, at
/// most pi / 2) of a sphere with the given radius, cut into level ground.
inline OracleField Bowl(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing,
  double sphereRadius, double halfAngle)
{
  const double rim = sphereRadius * std::sin(halfAngle);
  return FromFunction(columns, rows, spacing, spacing, columns / 2, rows / 2,
    [=](double x, double y)
    {
      const double d = std::hypot(x, y);
      return d >= rim
        ? 0.0
        : sphereRadius * std::cos(halfAngle) - std::sqrt(sphereRadius * sphereRadius - d * d);
    });
}

/// Level ground with one post of the given height.
inline OracleField Spike(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double height,
  std::ptrdiff_t column, std::ptrdiff_t row)
{
  OracleField field(columns, rows, spacing, spacing);
  field.At(column, row) = height;
  return field;
}

/// Level ground that is 'height' higher from row 'row' northwards.
inline OracleField Cliff(
  std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double height, std::ptrdiff_t row)
{
  return FromFunction(columns, rows, spacing, spacing, 0, row,
    [=](double, double y) { return y > -0.5 * spacing ? height : 0.0; });
}

/// Terraces: the ground rises by 'rise' after each 'tread' columns.
inline OracleField Steps(
  std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double rise, std::ptrdiff_t tread)
{
  OracleField field(columns, rows, spacing, spacing);
  for (std::ptrdiff_t j = 0; j < rows; ++j)
  {
    for (std::ptrdiff_t i = 0; i < columns; ++i)
    {
      const std::ptrdiff_t step = i / tread;
      field.At(i, j) = rise * static_cast<double>(step);
    }
  }
  return field;
}

/// Smooth hills: z = amplitude sin(2 pi x / wave) sin(2 pi y / wave).
inline OracleField EggTray(
  std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double amplitude, double wave)
{
  return FromFunction(columns, rows, spacing, spacing, 0, 0,
    [=](double x, double y)
    { return amplitude * std::sin(2.0 * Pi * x / wave) * std::sin(2.0 * Pi * y / wave); });
}

/// Adds a cone with the given height and radius (metres) to level ground, around a position given
/// in posts.
inline void AddCone(OracleField& field, double column, double row, double radius, double height)
{
  for (std::ptrdiff_t j = 0; j < field.Rows; ++j)
  {
    for (std::ptrdiff_t i = 0; i < field.Columns; ++i)
    {
      const double d = std::hypot((static_cast<double>(i) - column) * field.SpacingX,
        (static_cast<double>(j) - row) * field.SpacingY);
      field.At(i, j) = std::max(field.At(i, j), height * (1.0 - d / radius));
    }
  }
}

/// One cone in the middle of level ground.
inline OracleField Cone(
  std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double radius, double height)
{
  OracleField field(columns, rows, spacing, spacing);
  AddCone(field, 0.5 * static_cast<double>(columns - 1), 0.5 * static_cast<double>(rows - 1),
    radius, height);
  return field;
}

/// Cones, version 1: nine equal ones in three rows.
inline OracleField ConesInRows(
  std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double radius, double height)
{
  OracleField field(columns, rows, spacing, spacing);
  for (int k = 0; k < 9; ++k)
  {
    const int row = k / 3;
    AddCone(field, static_cast<double>(columns) * (1 + k % 3) / 4.0,
      static_cast<double>(rows) * (1 + row) / 4.0, radius, height);
  }
  return field;
}

/// Cones, version 2: eight of increasing size on a circle around the middle, whose radius is a
/// third of the field's width. The largest cone has the given radius and height.
inline OracleField ConesOnCircle(
  std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double radius, double height)
{
  OracleField field(columns, rows, spacing, spacing);
  for (int k = 0; k < 8; ++k)
  {
    const double turn = 2.0 * Pi * (k + 0.3) / 8.0;
    const double size = (k + 3) / 10.0;
    AddCone(field, static_cast<double>(columns) * (0.5 + std::sin(turn) / 3.0),
      static_cast<double>(rows) * (0.5 + std::cos(turn) / 3.0), size * radius, size * height);
  }
  return field;
}

/// A grating along the columns: z = amplitude sin(2 pi x / wave + phase). A changing phase makes
/// waves.
inline OracleField SineGrating(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing,
  double amplitude, double wave, double phase = 0.0)
{
  return FromFunction(columns, rows, spacing, spacing, 0, 0,
    [=](double x, double) { return amplitude * std::sin(2.0 * Pi * x / wave + phase); });
}

/// Waves: the sum of three trains of waves, each with its own direction, length and speed. 'wave'
/// is the greatest length; 'time' is counted in periods of that train.
inline OracleField Waves(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing,
  double amplitude, double wave, double time)
{
  return FromFunction(columns, rows, spacing, spacing, 0, 0,
    [=](double x, double y)
    {
      const auto train = [&](double part, double toward)
      {
        const double way = x * std::cos(toward) + y * std::sin(toward);
        // On deep water the speed is proportional to the square root of the length.
        return part * std::sin(2.0 * Pi * (way / (part * wave) - time / std::sqrt(part)));
      };
      return amplitude * (train(1.0, 0.3) + train(0.5, 1.1) + train(0.3, -0.7)) / 1.8;
    });
}

/// A city: blocks of 'block' posts between streets of 'street' posts. The height of each block is
/// 0.2 to 1 times 'height'.
inline OracleField City(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing,
  std::ptrdiff_t block, std::ptrdiff_t street, double height, std::uint64_t seed = 1)
{
  OracleField field(columns, rows, spacing, spacing);
  const std::ptrdiff_t period = block + street;
  for (std::ptrdiff_t j = 0; j < rows; ++j)
  {
    for (std::ptrdiff_t i = 0; i < columns; ++i)
    {
      if (i % period >= street && j % period >= street)
      {
        Random house(seed + static_cast<std::uint64_t>(i / period + 4096 * (j / period)));
        field.At(i, j) = height * (0.2 + 0.8 * house());
      }
    }
  }
  return field;
}

/// A relief like a teddy bear: half ellipsoids for body, head, ears, snout, arms and legs on a
/// plane.
inline OracleField Teddy(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double height)
{
  struct Part
  {
    double X, Y, Width, Length, Height; // as parts of the field's width, and of the height
  };
  const Part parts[] = { { 0.5, 0.38, 0.19, 0.23, 0.8 }, { 0.5, 0.69, 0.15, 0.14, 0.9 },
    { 0.37, 0.82, 0.06, 0.06, 0.5 }, { 0.63, 0.82, 0.06, 0.06, 0.5 },
    { 0.5, 0.65, 0.06, 0.05, 1.2 }, { 0.26, 0.5, 0.12, 0.06, 0.5 }, { 0.74, 0.5, 0.12, 0.06, 0.5 },
    { 0.37, 0.14, 0.08, 0.11, 0.6 }, { 0.63, 0.14, 0.08, 0.11, 0.6 } };
  OracleField field(columns, rows, spacing, spacing);
  for (std::ptrdiff_t j = 0; j < rows; ++j)
  {
    for (std::ptrdiff_t i = 0; i < columns; ++i)
    {
      for (const Part& part : parts)
      {
        const double x =
          (static_cast<double>(i) / static_cast<double>(columns - 1) - part.X) / part.Width;
        const double y =
          (static_cast<double>(j) / static_cast<double>(rows - 1) - part.Y) / part.Length;
        field.At(i, j) = std::max(
          field.At(i, j), height * part.Height * std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
      }
    }
  }
  return field;
}

/// A landslide: the heights of a slope after a part 'progress' (0 to 1) of a slab with the given
/// depth has moved from its upper half down to the foot. The slope rises northwards.
inline OracleField Landslide(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing,
  double slope, double depth, double progress)
{
  const double length = static_cast<double>(rows - 1) * spacing;
  const double middle = 0.5 * static_cast<double>(columns - 1) * spacing;
  return FromFunction(columns, rows, spacing, spacing, 0, 0,
    [=](double x, double y)
    {
      const double across = std::max(0.0, 1.0 - std::pow(2.5 * (x - middle) / middle, 2.0));
      const auto bump = [&](double centre)
      {
        const double v = (y / length - centre) / 0.2;
        return v * v < 1.0 ? (1.0 - v * v) * (1.0 - v * v) : 0.0;
      };
      return slope * y - depth * across * progress * (bump(0.7) - bump(0.25 + 0.1 * progress));
    });
}

/// A paraboloid z = curvature (x^2 + y^2) / 2 around the middle post: a bowl if the curvature is
/// positive, a dome if it is negative.
inline OracleField Paraboloid(
  std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing, double curvature)
{
  return FromFunction(columns, rows, spacing, spacing, columns / 2, rows / 2,
    [=](double x, double y) { return 0.5 * curvature * (x * x + y * y); });
}

/// Fractal terrain by midpoint displacement (diamond-square; Fournier, Fussell, Carpenter 1982),
/// cut from a square of 2^n + 1 posts. Heights are 0 to 'relief'. Each halving of the step
/// multiplies the displacement by 'roughness' (0.5 smooth, 0.7 jagged).
inline OracleField Fractal(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing,
  double relief, std::uint64_t seed = 1, double roughness = 0.55)
{
  std::ptrdiff_t size = 2;
  while (size + 1 < std::max(columns, rows))
  {
    size *= 2;
  }
  const std::ptrdiff_t n = size + 1;
  std::vector<double> z(static_cast<std::size_t>(n * n), 0.0);
  Random random(seed);
  const auto at = [&](std::ptrdiff_t i, std::ptrdiff_t j) -> double&
  { return z[static_cast<std::size_t>(j * n + i)]; };
  double amplitude = 1.0;
  const auto jitter = [&]() { return amplitude * (2.0 * random() - 1.0); };
  at(0, 0) = jitter();
  at(size, 0) = jitter();
  at(0, size) = jitter();
  at(size, size) = jitter();
  for (std::ptrdiff_t step = size; step > 1; step /= 2)
  {
    const std::ptrdiff_t half = step / 2;
    for (std::ptrdiff_t j = half; j < n; j += step)
    {
      for (std::ptrdiff_t i = half; i < n; i += step)
      {
        at(i, j) = 0.25 *
            (at(i - half, j - half) + at(i + half, j - half) + at(i - half, j + half) +
              at(i + half, j + half)) +
          jitter();
      }
    }
    for (std::ptrdiff_t j = 0; j < n; j += half)
    {
      for (std::ptrdiff_t i = (j / half) % 2 == 0 ? half : 0; i < n; i += step)
      {
        double sum = 0.0;
        int count = 0;
        const std::ptrdiff_t around[4][2] = { { i - half, j }, { i + half, j }, { i, j - half },
          { i, j + half } };
        for (const auto& p : around)
        {
          if (p[0] >= 0 && p[1] >= 0 && p[0] < n && p[1] < n)
          {
            sum += at(p[0], p[1]);
            ++count;
          }
        }
        at(i, j) = sum / count + jitter();
      }
    }
    amplitude *= roughness;
  }
  OracleField field(columns, rows, spacing, spacing);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::ptrdiff_t j = 0; j < rows; ++j)
  {
    for (std::ptrdiff_t i = 0; i < columns; ++i)
    {
      field.At(i, j) = at(i, j);
      low = std::min(low, at(i, j));
      high = std::max(high, at(i, j));
    }
  }
  for (double& h : field.Heights)
  {
    h = relief * (h - low) / (high - low);
  }
  return field;
}

/// Level ground with 'count' random boxes of up to 'size' posts and up to 'height' metres. Where
/// two boxes overlap, the higher one counts.
inline OracleField RandomBoxes(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacing,
  std::ptrdiff_t count, std::ptrdiff_t size, double height, std::uint64_t seed = 1)
{
  OracleField field(columns, rows, spacing, spacing);
  Random random(seed);
  for (std::ptrdiff_t k = 0; k < count; ++k)
  {
    const std::ptrdiff_t i0 = random.Below(columns), j0 = random.Below(rows);
    const std::ptrdiff_t i1 = std::min(columns, i0 + 1 + random.Below(size));
    const std::ptrdiff_t j1 = std::min(rows, j0 + 1 + random.Below(size));
    const double top = height * random();
    for (std::ptrdiff_t j = j0; j < j1; ++j)
    {
      for (std::ptrdiff_t i = i0; i < i1; ++i)
      {
        field.At(i, j) = std::max(field.At(i, j), top);
      }
    }
  }
  return field;
}

/// Removes 'count' round areas of up to 'radius' posts from a field.
inline void RemoveIslands(
  OracleField& field, std::ptrdiff_t count, std::ptrdiff_t radius, std::uint64_t seed = 1)
{
  Random random(seed);
  for (std::ptrdiff_t k = 0; k < count; ++k)
  {
    const std::ptrdiff_t i0 = random.Below(field.Columns), j0 = random.Below(field.Rows);
    const std::ptrdiff_t r = random.Below(radius + 1); // 0: a single post
    for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(0, j0 - r);
         j <= std::min(field.Rows - 1, j0 + r); ++j)
    {
      for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, i0 - r);
           i <= std::min(field.Columns - 1, i0 + r); ++i)
      {
        if ((i - i0) * (i - i0) + (j - j0) * (j - j0) <= r * r)
        {
          field.At(i, j) = std::numeric_limits<double>::quiet_NaN();
        }
      }
    }
  }
}

} // namespace shapes
} // namespace skyline

#endif
