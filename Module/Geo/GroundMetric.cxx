// SPDX-License-Identifier: BSD-3-Clause
#include "Geo/GroundMetric.h"

#include "Geo/LatticePlace.h"
#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace skyline
{
namespace
{

/// Nodes along a side of the first lattice and of the finest one.
constexpr std::ptrdiff_t FirstNodes = 9;
constexpr std::ptrdiff_t LastNodes = 257;

/// A raster whose longer side is shorter than this (metres) keeps its nominal spacing. Longitudes
/// do not have enough digits for its posts, and no map is distorted over such a length.
constexpr double ShortestSide = 1.0;

/// Columns closer together than this part of the distance between rows are about to meet in a
/// point.
constexpr double SmallestScaleRatio = 0.05;

/// Part of a row by which a row is moved away from a point where all columns meet (a pole). This
/// gives the mean over the half row that its posts stand for.
constexpr double RowShift = 0.25;

std::string PostText(double column, double row)
{
  return std::to_string(std::lround(column)) + "," + std::to_string(std::lround(row));
}

[[noreturn]] void RefusePost(double column, double row, const std::string& what)
{
  throw std::invalid_argument("post " + PostText(column, row) + " " + what +
    "; cut the raster to where its map is defined, or warp it to a local map such as UTM (gdalwarp "
    "-t_srs)");
}

/// Metric of a post from the lattice. X is 0 or a rounding error where a row is a single point (a
/// pole).
PostMetric MetricOfLattice(const Georeference& place, double column, double row)
{
  const PostSteps steps = place.StepsAt(column, row);
  PostMetric metric;
  metric.Y = std::hypot(steps.EastPerRow, steps.NorthPerRow);
  metric.X =
    (steps.EastPerColumn * steps.NorthPerRow - steps.EastPerRow * steps.NorthPerColumn) / metric.Y;
  metric.Shear =
    (steps.EastPerColumn * steps.EastPerRow + steps.NorthPerColumn * steps.NorthPerRow) / metric.Y;
  constexpr double nothing = 1e-6; // of a step; anything less is a point
  if (!(metric.Y > 0.0) || !(metric.X > -nothing * metric.Y) || !std::isfinite(metric.X) ||
    !std::isfinite(metric.Shear))
  {
    RefusePost(column, row,
      "has steps of " + std::to_string(metric.X) + " x " + std::to_string(metric.Y) +
        " m on the ground, from which no distances follow");
  }
  metric.X = std::max(metric.X, 0.0);
  return metric;
}

PostMetric Mix(const PostMetric& a, const PostMetric& b, double fraction)
{
  return { a.X + fraction * (b.X - a.X), a.Shear + fraction * (b.Shear - a.Shear),
    a.Y + fraction * (b.Y - a.Y) };
}

bool Within(const MetricError& error, double distance, double radians)
{
  return error.Distance <= distance && error.Azimuth <= radians;
}

/// Position of a post between `nodes` nodes that are spread evenly over `posts` posts.
LatticePlace PlaceAmong(double post, std::ptrdiff_t posts, std::ptrdiff_t nodes)
{
  const double scale = static_cast<double>(nodes - 1) / static_cast<double>(posts - 1);
  return { post * scale, nodes };
}

/// Calls set(i, value) for `count` posts of a row, starting at `column`. Values are linear between
/// nodes; at(node, post) gives them.
template <typename At, typename Set>
void ForLinearRow(std::ptrdiff_t column, std::ptrdiff_t count, std::ptrdiff_t posts,
  std::ptrdiff_t nodes, const At& at, const Set& set)
{
  const double cell = static_cast<double>(posts - 1) / static_cast<double>(nodes - 1);
  for (std::ptrdiff_t i = 0; i < count;)
  {
    const std::ptrdiff_t node = PlaceAmong(static_cast<double>(column + i), posts, nodes).Lower;
    const double west = static_cast<double>(node) * cell;
    const double from = at(node, west), step = (at(node + 1, west + cell) - from) / cell;
    const bool last = node + 2 >= nodes;
    do
    {
      set(i, static_cast<float>(from + step * (static_cast<double>(column + i) - west)));
      ++i;
    } while (i < count && (last || static_cast<double>(column + i) < west + cell));
  }
}

} // namespace

MetricError ErrorOf(const PostMetric& used, const PostMetric& truth)
{
  // The map from the assumed to the true end of a ray, (p 0; r s), is the sum of a rotation with
  // scale and a mirrored one: z -> A z + B conj(z). A direction turns by arg A, and by at most
  // asin(|B| / |A|) more to either side. A length is multiplied by |A| - |B| to |A| + |B|.
  const double p = truth.X / used.X;
  const double s = truth.Y / used.Y;
  const double r = (truth.Shear - used.Shear * s) / used.X;
  const double turn = 0.5 * std::hypot(p + s, r);
  const double fold = 0.5 * std::hypot(p - s, r);
  MetricError error;
  error.Azimuth = std::abs(std::atan2(r, p + s)) + std::asin(std::min(1.0, fold / turn));
  error.Distance = std::max(std::abs(turn + fold - 1.0), std::abs(turn - fold - 1.0));
  return error;
}

double LengthOf(const PostMetric& metric, double columns, double rows)
{
  return std::hypot(metric.X * columns, metric.Shear * columns + metric.Y * rows);
}

GroundMetric::GroundMetric(const Georeference& place, const PostSpacing& image)
  : ColumnCount(std::max<std::ptrdiff_t>(place.Columns, 2))
  , RowCount(std::max<std::ptrdiff_t>(place.Rows, 2))
  , ImageX(image.X)
  , ImageY(image.Y)
{
  const PostMetric plain{ image.X, 0.0, image.Y };
  const auto rows = static_cast<std::size_t>(std::max<std::ptrdiff_t>(place.Rows, 0));
  if (!place.RowSpacingX.empty() &&
    (place.RowSpacingX.size() != rows || place.RowSpacingY.size() != rows))
  {
    throw std::invalid_argument("there are " + std::to_string(place.RowSpacingX.size()) +
      " row spacings for " + std::to_string(place.Rows) + " rows; give one per row");
  }
  if (rows >= 2 && !place.RowSpacingX.empty())
  {
    this->TrueImage = true;
    this->SpacingX = place.RowSpacingX;
    this->SpacingY = place.RowSpacingY;
    this->Across = 1;
    this->Along = place.Rows;
    for (std::size_t row = 0; row < rows; ++row)
    {
      this->Nodes.push_back({ place.RowSpacingX[row], 0.0, place.RowSpacingY[row] });
    }
    return;
  }
  const double side = std::max(
    image.X * static_cast<double>(place.Columns), image.Y * static_cast<double>(place.Rows));
  if (place.OnBody() && side >= ShortestSide)
  {
    this->TrueImage = place.InDegrees || !place.HasGeoTransform || place.FollowsGraticule();
    if (!this->TrueImage)
    {
      this->ImageX = std::abs(place.GeoTransform[1]);
      this->ImageY = std::abs(place.GeoTransform[5]);
    }
    std::ptrdiff_t nodes = FirstNodes;
    while (!this->Sample(place, nodes))
    {
      nodes = 2 * nodes - 1;
    }
    // Azimuths on the image must use the spacing of the image, too.
    const PostMetric plane{ this->ImageX, 0.0, this->ImageY };
    const double radians = AzimuthTolerance * RadiansPerDegree;
    if (!Within(this->WorstError(plain), DistanceTolerance, radians) ||
      (!this->TrueImage && ErrorOf(plane, plain).Azimuth > radians))
    {
      return;
    }
  }
  this->Across = this->Along = 1;
  this->Nodes.assign(1, plain);
}

bool GroundMetric::Sample(const Georeference& place, std::ptrdiff_t side)
{
  GroundMetric finer = *this;
  finer.Across = finer.Along = side;
  finer.Nodes.clear();
  finer.Nodes.reserve(static_cast<std::size_t>(side * side));
  const auto last = static_cast<double>(side - 1);
  double worst = 0.0, worstColumn = 0.0, worstRow = 0.0;
  for (std::ptrdiff_t j = 0; j < side; ++j)
  {
    const double row = static_cast<double>(j) * static_cast<double>(this->RowCount - 1) / last;
    for (std::ptrdiff_t i = 0; i < side; ++i)
    {
      const double column =
        static_cast<double>(i) * static_cast<double>(this->ColumnCount - 1) / last;
      const PostMetric node = MetricOfLattice(place, column, row);
      finer.Collapses = finer.Collapses || node.X < SmallestScaleRatio * node.Y;
      finer.Nodes.push_back(node);
      if (this->Nodes.empty() || node.X < SmallestScaleRatio * node.Y)
      {
        continue;
      }
      const MetricError error = ErrorOf(this->At(column, row), node);
      if (std::max(error.Distance, error.Azimuth) > worst)
      {
        worst = std::max(error.Distance, error.Azimuth);
        worstColumn = column;
        worstRow = row;
      }
    }
  }
  // If the coarser lattice predicts these nodes within four times the tolerance, interpolation
  // between these nodes keeps the tolerance.
  const bool good = !this->Nodes.empty() && worst <= 4.0 * NodeTolerance;
  if (side >= LastNodes && worst > 4.0 * DistanceTolerance)
  {
    RefusePost(worstColumn, worstRow,
      "lies where the map's lengths or directions change by a fraction of " +
        std::to_string(worst) +
        " over a few posts, so that distances there may be wrong by 0.001 of their length");
  }
  *this = finer;
  return good || side >= LastNodes;
}

PostMetric GroundMetric::Between(double column, double row) const
{
  const LatticePlace across = PlaceAmong(column, this->ColumnCount, this->Across);
  const LatticePlace along = PlaceAmong(row, this->RowCount, this->Along);
  return Mix(Mix(this->Node(across.Lower, along.Lower), this->Node(across.Upper, along.Lower),
               across.Fraction),
    Mix(this->Node(across.Lower, along.Upper), this->Node(across.Upper, along.Upper),
      across.Fraction),
    along.Fraction);
}

PostMetric GroundMetric::At(double column, double row) const
{
  const PostMetric metric = this->Between(column, row);
  if (this->Collapses)
  {
    const bool south = row < 0.5 * static_cast<double>(this->RowCount - 1);
    const PostMetric inward = this->Between(column, south ? row + RowShift : row - RowShift);
    if (metric.X < 0.5 * inward.X)
    {
      return inward;
    }
  }
  return metric;
}

PostMetric GroundMetric::Centre() const
{
  return this->At(0.5 * static_cast<double>(this->ColumnCount - 1),
    0.5 * static_cast<double>(this->RowCount - 1));
}

MetricError GroundMetric::WorstError(const PostMetric& used) const
{
  MetricError worst;
  for (const PostMetric& node : this->Nodes)
  {
    const MetricError error = ErrorOf(used, node);
    worst.Azimuth = std::max(worst.Azimuth, error.Azimuth);
    worst.Distance = std::max(worst.Distance, error.Distance);
  }
  return worst;
}

double GroundMetric::GroundAzimuth(const PostMetric& metric, double imageAzimuth) const
{
  if (this->Uniform() || (this->TrueImage && metric.Shear == 0.0))
  {
    return imageAzimuth;
  }
  const double stepX = this->TrueImage ? std::hypot(metric.X, metric.Shear) : this->ImageX;
  const double stepY = this->TrueImage ? metric.Y : this->ImageY;
  const double columns = std::sin(imageAzimuth) / stepX, rows = std::cos(imageAzimuth) / stepY;
  return std::atan2(metric.X * columns, metric.Shear * columns + metric.Y * rows);
}

void GroundMetric::Lengths(std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t count,
  double columns, double rows, float* metres) const
{
  const auto line = static_cast<double>(row);
  const auto at = [&](double post) { return LengthOf(this->At(post, line), columns, rows); };
  if (this->Across < 2)
  {
    std::fill_n(metres, count, static_cast<float>(at(0.0)));
    return;
  }
  ForLinearRow(
    column, count, this->ColumnCount, this->Across,
    [&](std::ptrdiff_t, double post) { return at(post); },
    [metres](std::ptrdiff_t i, float length) { metres[i] = length; });
}

void GroundMetric::Interpolate(const std::vector<float>& nodes, std::ptrdiff_t row,
  std::ptrdiff_t column, std::ptrdiff_t count, float* values) const
{
  const LatticePlace along = PlaceAmong(static_cast<double>(row), this->RowCount, this->Along);
  const float* south = nodes.data() + along.Lower * this->Across;
  const float* north = nodes.data() + along.Upper * this->Across;
  const auto at = [&](std::ptrdiff_t i)
  {
    return south[i] +
      along.Fraction * (static_cast<double>(north[i]) - static_cast<double>(south[i]));
  };
  if (this->Across < 2)
  {
    std::fill_n(values, count, static_cast<float>(at(0)));
    return;
  }
  ForLinearRow(
    column, count, this->ColumnCount, this->Across,
    [&](std::ptrdiff_t node, double) { return at(node); },
    [values](std::ptrdiff_t i, float value) { values[i] = value; });
}

void GroundMetric::TurnGradients(
  std::ptrdiff_t row, const PostSpacing& image, std::ptrdiff_t count, float* x, float* y) const
{
  if (this->Uniform())
  {
    return;
  }
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    const PostMetric metric = this->At(static_cast<double>(i), static_cast<double>(row));
    const double perColumn = x[i] * image.X, perRow = y[i] * image.Y;
    const double north = perRow / metric.Y;
    x[i] = static_cast<float>((perColumn - north * metric.Shear) / metric.X);
    y[i] = static_cast<float>(north);
  }
}

} // namespace skyline
