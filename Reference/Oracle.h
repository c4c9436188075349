// SPDX-License-Identifier: BSD-3-Clause
// The oracle: horizons, sky and sun in double precision by the simplest loops. For tests only.
#ifndef skyline_Oracle_h
#define skyline_Oracle_h

#include "HeightField/Grid.h"
#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace skyline
{
namespace oracle
{

/// The slope where there is no terrain in a direction.
constexpr double NoTerrain = static_cast<double>(NoTerrainSlope);

/// A crossing within this distance of a post, in spacings, counts as the post. This replaces exact
/// arithmetic: positions along a ray have errors of about 1e-11 spacings.
constexpr double PostSnap = 1.0e-9;

/// The height field on which the oracle works.
struct OracleField
{
  std::ptrdiff_t Columns = 0;           ///< posts from west to east
  std::ptrdiff_t Rows = 0;              ///< posts from south to north
  double SpacingX = 1.0;                ///< metres between columns
  double SpacingY = 1.0;                ///< metres between rows
  std::vector<double> Heights;          ///< metres, row by row from the south; not finite: missing
  Surface Through = Surface::Triangles; ///< the surface through the posts
  double CurvatureDrop = 0.0;           ///< c in 1/m: the surface at distance d is lowered by c d^2

  OracleField() = default;
  OracleField(std::ptrdiff_t columns, std::ptrdiff_t rows, double spacingX, double spacingY)
    : Columns(columns)
    , Rows(rows)
    , SpacingX(spacingX)
    , SpacingY(spacingY)
    , Heights(static_cast<std::size_t>(columns * rows), 0.0)
  {
  }

  std::size_t Index(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    return static_cast<std::size_t>(row * this->Columns + column);
  }
  double& At(std::ptrdiff_t column, std::ptrdiff_t row)
  {
    return this->Heights[this->Index(column, row)];
  }
  double At(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    return this->Heights[this->Index(column, row)];
  }
  bool HasPost(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    return column >= 0 && row >= 0 && column < this->Columns && row < this->Rows &&
      std::isfinite(this->At(column, row));
  }
  /// A cell is identified by its south-western post. It has a surface if its four posts exist.
  bool HasCell(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    return this->HasPost(column, row) && this->HasPost(column + 1, row) &&
      this->HasPost(column, row + 1) && this->HasPost(column + 1, row + 1);
  }
  /// A post is an occluder if it is the corner of a complete cell.
  bool PostOccludes(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    return this->HasCell(column - 1, row - 1) || this->HasCell(column, row - 1) ||
      this->HasCell(column - 1, row) || this->HasCell(column, row);
  }
};

/// A horizontal unit vector.
struct Direction
{
  double East = 0.0;
  double North = 1.0;
};

/// The direction of an azimuth in degrees clockwise from north. Exact at multiples of 45 degrees.
inline Direction DirectionOfAzimuth(double degrees)
{
  const double half = std::sqrt(0.5);
  const Direction compass[8] = { { 0.0, 1.0 }, { half, half }, { 1.0, 0.0 }, { half, -half },
    { 0.0, -1.0 }, { -half, -half }, { -1.0, 0.0 }, { -half, half } };
  double turned = std::fmod(degrees, 360.0);
  turned = turned < 0.0 ? turned + 360.0 : turned;
  const double eighths = turned / 45.0;
  // 1e-12 of 45 degrees is the error that a conversion to radians and back can cause.
  if (std::abs(eighths - std::round(eighths)) < 1e-12)
  {
    return compass[static_cast<int>(std::round(eighths)) % 8];
  }
  return { std::sin(turned * RadiansPerDegree), std::cos(turned * RadiansPerDegree) };
}

namespace detail
{

/// The height of the surface where the ray crosses a line of posts. 'along' is the position on the
/// line, between post 'floor(along)' and the next one.
/// 'edge(k)' tells whether the edge from k to k + 1 belongs to a complete cell, 'post(k)' whether
/// post k does. 'height(k)' is the height of post k.
template <class Edge, class Post, class Height>
bool LineHeight(double along, const Edge& edge, const Post& post, const Height& height, double& z)
{
  const double nearest = std::round(along);
  if (std::abs(along - nearest) < PostSnap)
  {
    const auto k = static_cast<std::ptrdiff_t>(nearest);
    if (!post(k))
    {
      return false;
    }
    z = height(k);
    return true;
  }
  const auto k = static_cast<std::ptrdiff_t>(std::floor(along));
  if (!edge(k))
  {
    return false;
  }
  const double f = along - static_cast<double>(k);
  z = (1.0 - f) * height(k) + f * height(k + 1);
  return true;
}

} // namespace detail

/// The slope (tangent of the elevation) of the horizon of the post (column, row) in a direction:
/// the greatest over all crossings of row, column and diagonal edges from the post to the edge of
/// the data. With the bilinear surface, the inside of the cells counts too.
/// Returns NoTerrain if there is no terrain, and NaN if the post is missing. A complete cell counts
/// even if the ray only touches one of its corners.
inline double HorizonSlope(
  const OracleField& field, std::ptrdiff_t column, std::ptrdiff_t row, const Direction& direction)
{
  if (!field.HasPost(column, row))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double z0 = field.At(column, row);
  const double x0 = static_cast<double>(column);
  const double y0 = static_cast<double>(row);
  const double lastX = static_cast<double>(field.Columns - 1);
  const double lastY = static_cast<double>(field.Rows - 1);
  const double u = direction.East / field.SpacingX;  // columns per metre
  const double v = direction.North / field.SpacingY; // rows per metre
  double best = NoTerrain;

  const auto offer = [&](double distance, double z)
  { best = std::max(best, (z - z0 - field.CurvatureDrop * distance * distance) / distance); };
  const auto inside = [&](double x, double y)
  { return x >= -PostSnap && y >= -PostSnap && x <= lastX + PostSnap && y <= lastY + PostSnap; };

  // Columns of posts: the ray crosses each at the row y.
  if (u != 0.0)
  {
    const int step = u > 0.0 ? 1 : -1;
    for (std::ptrdiff_t i = column + step; i >= 0 && i < field.Columns; i += step)
    {
      const double run = static_cast<double>(i - column);
      const double y = y0 + run * (v / u);
      if (!inside(static_cast<double>(i), y))
      {
        break;
      }
      double z = 0.0;
      if (detail::LineHeight(
            y, [&](std::ptrdiff_t j) { return field.HasCell(i - 1, j) || field.HasCell(i, j); },
            [&](std::ptrdiff_t j) { return field.PostOccludes(i, j); },
            [&](std::ptrdiff_t j) { return field.At(i, j); }, z))
      {
        offer(run / u, z);
      }
    }
  }

  // Rows of posts: the ray crosses each at the column x.
  if (v != 0.0)
  {
    const int step = v > 0.0 ? 1 : -1;
    for (std::ptrdiff_t j = row + step; j >= 0 && j < field.Rows; j += step)
    {
      const double run = static_cast<double>(j - row);
      const double x = x0 + run * (u / v);
      if (!inside(x, static_cast<double>(j)))
      {
        break;
      }
      double z = 0.0;
      if (detail::LineHeight(
            x, [&](std::ptrdiff_t i) { return field.HasCell(i, j - 1) || field.HasCell(i, j); },
            [&](std::ptrdiff_t i) { return field.PostOccludes(i, j); },
            [&](std::ptrdiff_t i) { return field.At(i, j); }, z))
      {
        offer(run / v, z);
      }
    }
  }

  // Diagonals, where column - row is constant. Posts on a diagonal have been counted already.
  if (field.Through == Surface::Triangles && u != v)
  {
    const int step = u > v ? 1 : -1;
    for (std::ptrdiff_t m = step;; m += step)
    {
      const double run = static_cast<double>(m);
      const double x = x0 + run * (u / (u - v));
      const double y = y0 + run * (v / (u - v));
      if (!inside(x, y))
      {
        break;
      }
      if (std::abs(x - std::round(x)) < PostSnap)
      {
        continue;
      }
      const auto i = static_cast<std::ptrdiff_t>(std::floor(x));
      const auto j = i - (column - row) - m;
      if (field.HasCell(i, j))
      {
        const double f = x - static_cast<double>(i);
        offer(run / (u - v), (1.0 - f) * field.At(i, j) + f * field.At(i + 1, j + 1));
      }
    }
  }

  // The inside of bilinear cells. The height there is a quadratic function of the distance s, and
  // (A + B s + C s^2) / s has the maximum B - 2 sqrt(A C) at s = sqrt(A / C) if A < 0 and C < 0.
  // Along a row or column of posts the height is linear, and the edges have been counted already.
  if (field.Through == Surface::Bilinear && u != 0.0 && v != 0.0)
  {
    std::vector<double> places; // distances at which the ray enters another cell
    places.push_back(0.0);
    for (std::ptrdiff_t i = 0; i < field.Columns; ++i)
    {
      places.push_back(static_cast<double>(i - column) / u);
    }
    for (std::ptrdiff_t j = 0; j < field.Rows; ++j)
    {
      places.push_back(static_cast<double>(j - row) / v);
    }
    std::sort(places.begin(), places.end());
    for (std::size_t p = 0; p + 1 < places.size(); ++p)
    {
      const double s0 = places[p];
      const double s1 = places[p + 1];
      if (s0 < 0.0 || s1 <= s0)
      {
        continue;
      }
      const double middle = 0.5 * (s0 + s1);
      const auto i = static_cast<std::ptrdiff_t>(std::floor(x0 + u * middle));
      const auto j = static_cast<std::ptrdiff_t>(std::floor(y0 + v * middle));
      if (!field.HasCell(i, j))
      {
        continue;
      }
      const double z00 = field.At(i, j);
      const double east = field.At(i + 1, j) - z00;
      const double north = field.At(i, j + 1) - z00;
      const double twist = field.At(i + 1, j + 1) - z00 - east - north;
      const double f = x0 - static_cast<double>(i); // relative to the corner of the cell
      const double g = y0 - static_cast<double>(j);
      const double a = z00 + east * f + north * g + twist * f * g - z0;
      const double b = east * u + north * v + twist * (f * v + g * u);
      const double c = twist * u * v - field.CurvatureDrop;
      if (s0 == 0.0)
      {
        best = std::max(best, b); // the limit at the receiver, where a is 0
      }
      else if (a < 0.0 && c < 0.0)
      {
        const double s = std::sqrt(a / c);
        if (s > s0 && s < s1)
        {
          best = std::max(best, b - 2.0 * std::sqrt(a * c));
        }
      }
    }
  }
  return best;
}

/// The same for an azimuth in radians clockwise from north. Multiples of 45 degrees are recognised.
inline double HorizonSlope(
  const OracleField& field, std::ptrdiff_t column, std::ptrdiff_t row, double azimuthRadians)
{
  return HorizonSlope(field, column, row, DirectionOfAzimuth(azimuthRadians * DegreesPerRadian));
}

/// Horizon slopes of all posts in one azimuth (degrees), row by row from the south.
inline std::vector<double> HorizonSlopes(const OracleField& field, double azimuthDegrees)
{
  const Direction direction = DirectionOfAzimuth(azimuthDegrees);
  std::vector<double> slopes(field.Heights.size());
  for (std::ptrdiff_t j = 0; j < field.Rows; ++j)
  {
    for (std::ptrdiff_t i = 0; i < field.Columns; ++i)
    {
      slopes[field.Index(i, j)] = HorizonSlope(field, i, j, direction);
    }
  }
  return slopes;
}

/// Elevation of a slope in degrees; -90 where there is no terrain.
inline double ElevationDegrees(double slope)
{
  return slope == NoTerrain ? -90.0 : std::atan(slope) * DegreesPerRadian;
}

/// Gradient (dz/dx, dz/dy) at a post: central differences, one-sided at the edge and beside missing
/// posts, 0 if neither neighbour exists.
inline void Gradient(
  const OracleField& field, std::ptrdiff_t column, std::ptrdiff_t row, double& east, double& north)
{
  const auto difference = [&](std::ptrdiff_t di, std::ptrdiff_t dj, double spacing)
  {
    const bool before = field.HasPost(column - di, row - dj);
    const bool after = field.HasPost(column + di, row + dj);
    const double low = before ? field.At(column - di, row - dj) : field.At(column, row);
    const double high = after ? field.At(column + di, row + dj) : field.At(column, row);
    const int steps = (before ? 1 : 0) + (after ? 1 : 0);
    return steps == 0 ? 0.0 : (high - low) / (steps * spacing);
  };
  east = difference(1, 0, field.SpacingX);
  north = difference(0, 1, field.SpacingY);
}

/// The sky that a post sees.
struct Sky
{
  double SkyViewFactor = 0.0;
  double SkyViewFactorHorizontal = 0.0;
  double VisibleSkyFraction = 0.0;
  double PositiveOpenness = 0.0; ///< degrees
  double UniformAmbient = 0.0;
};

/// The sky from the slopes of the horizons in N evenly spaced azimuths, of which the first is
/// north, and from the gradient of the receiver's plane. Simple midpoint sums over 'steps'
/// elevations.
inline Sky SkyFromHorizons(
  const std::vector<double>& slopes, double east, double north, int steps = 4000)
{
  Sky sky;
  const double length = std::sqrt(1.0 + east * east + north * north);
  const auto count = static_cast<double>(slopes.size());
  const double width = 2.0 * Pi / count;
  for (std::size_t k = 0; k < slopes.size(); ++k)
  {
    const double azimuth = width * static_cast<double>(k);
    const double across = -(east * std::sin(azimuth) + north * std::cos(azimuth)) / length;
    const double up = 1.0 / length;
    const double horizon = ElevationDegrees(slopes[k]) * RadiansPerDegree;
    const auto integrate = [&](double from, const std::function<double(double)>& f)
    {
      const double step = (0.5 * Pi - from) / steps;
      double sum = 0.0;
      for (int s = 0; s < steps; ++s)
      {
        sum += f(from + (s + 0.5) * step);
      }
      return sum * step;
    };
    // Light from the elevation e reaches the plane with the factor n.d. The circumference of a ring
    // of elevations is proportional to cos e.
    const double sky0 = std::max(horizon, 0.0);
    sky.SkyViewFactor += width / Pi *
      integrate(sky0,
        [&](double e)
        { return std::max(0.0, up * std::sin(e) + across * std::cos(e)) * std::cos(e); });
    sky.SkyViewFactorHorizontal +=
      width / Pi * integrate(sky0, [](double e) { return std::sin(e) * std::cos(e); });
    sky.VisibleSkyFraction +=
      width / (2.0 * Pi) * integrate(sky0, [](double e) { return std::cos(e); });
    sky.PositiveOpenness += (90.0 - horizon * DegreesPerRadian) / count;
    // TW10 equation 5 takes the horizon and the limit of the plane as constant over the swath, and
    // integrates the cosine over it: the mean of cos over the swath is sin(w/2) / (w/2).
    const double limit = std::max(horizon, std::atan2(-across, up));
    const double mean = std::sin(0.5 * width) / (0.5 * width);
    sky.UniformAmbient += width / Pi *
      integrate(limit,
        [&](double e) { return (up * std::sin(e) + mean * across * std::cos(e)) * std::cos(e); });
  }
  return sky;
}

/// A horizon that is given in some azimuths (radians, ascending; elevations in radians). Between
/// them the elevation is linear; before the first and after the last one it is constant.
struct HorizonCurve
{
  std::vector<double> Azimuths;
  std::vector<double> Elevations;
  bool Closed = false; ///< true: the last azimuth is connected to the first, plus 2 pi

  double operator()(double azimuth) const
  {
    const std::size_t n = this->Azimuths.size();
    // Brings the azimuth to within pi of the middle of the curve.
    const double middle = 0.5 * (this->Azimuths.front() + this->Azimuths.back());
    double a = this->Closed ? azimuth - this->Azimuths.front() : azimuth - middle;
    a = this->Closed ? a - 2.0 * Pi * std::floor(a / (2.0 * Pi)) + this->Azimuths.front()
                     : std::remainder(a, 2.0 * Pi) + middle;
    if (!this->Closed && a <= this->Azimuths.front())
    {
      return this->Elevations.front();
    }
    for (std::size_t k = 0; k + 1 < n; ++k)
    {
      if (a <= this->Azimuths[k + 1])
      {
        const double f = (a - this->Azimuths[k]) / (this->Azimuths[k + 1] - this->Azimuths[k]);
        return (1.0 - f) * this->Elevations[k] + f * this->Elevations[k + 1];
      }
    }
    if (!this->Closed)
    {
      return this->Elevations.back();
    }
    const double gap = this->Azimuths.front() + 2.0 * Pi - this->Azimuths.back();
    const double f = (a - this->Azimuths.back()) / gap;
    return (1.0 - f) * this->Elevations.back() + f * this->Elevations.front();
  }
};

/// The visible fraction of the sun's disc (azimuth, elevation and angular radius in radians) above
/// a horizon (a function from azimuth to elevation, both in radians), by rings x spokes samples of
/// equal solid angle. Limb darkening: I = 1 - u (1 - mu), where mu is the cosine of the angle on
/// the surface of the sun.
inline double LitFraction(double azimuth, double elevation, double radius,
  const std::function<double(double)>& horizon, double u = 0.0, int rings = 400, int spokes = 1200)
{
  const double ce = std::cos(elevation), se = std::sin(elevation);
  const double ca = std::cos(azimuth), sa = std::sin(azimuth);
  // The direction of the sun, and the directions to the right of it and upwards from it on the
  // sphere.
  const double sun[3] = { ce * sa, ce * ca, se };
  const double side[3] = { ca, -sa, 0.0 };
  const double over[3] = { -se * sa, -se * ca, ce };
  double lit = 0.0, all = 0.0;
  for (int r = 0; r < rings; ++r)
  {
    // For equal solid angles, 1 - cos of the ring's angle grows evenly; 1 - cos = 2 sin^2(angle /
    // 2).
    const double share = (r + 0.5) / rings;
    const double s = std::sin(0.5 * radius) * std::sqrt(share);
    const double angle = 2.0 * std::asin(s);
    const double weight = 1.0 - u * (1.0 - std::sqrt(1.0 - share));
    for (int p = 0; p < spokes; ++p)
    {
      const double turn = 2.0 * Pi * (p + 0.5) / spokes;
      double d[3];
      for (int k = 0; k < 3; ++k)
      {
        d[k] = std::cos(angle) * sun[k] +
          std::sin(angle) * (std::cos(turn) * side[k] + std::sin(turn) * over[k]);
      }
      const double e = std::atan2(d[2], std::hypot(d[0], d[1]));
      all += weight;
      lit += e > horizon(std::atan2(d[0], d[1])) ? weight : 0.0;
    }
  }
  return lit / all;
}

} // namespace oracle
} // namespace skyline

#endif
