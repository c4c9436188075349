// SPDX-License-Identifier: BSD-3-Clause
#include "Geo/Georeference.h"

#include "Geo/Azimuth.h"
#include "Shared/Constants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace skyline
{
namespace
{

/// Nodes whose coordinates differ by less than this (degrees; 0.1 mm on the Earth) lie on the same
/// meridian or parallel.
constexpr double SameDegrees = 1e-9;

/// Up to three lattice nodes around a post along one axis: Lagrange weights and their derivatives.
struct Stencil
{
  int First = 0;
  int Count = 0;
  double Weight[3] = { 0.0, 0.0, 0.0 };
  double Slope[3] = { 0.0, 0.0, 0.0 }; // per post

  Stencil(double post, std::ptrdiff_t posts, int nodes)
    : Count(std::min(nodes, 3))
  {
    const double nodesPerPost = static_cast<double>(nodes - 1) / static_cast<double>(posts - 1);
    const double position = post * nodesPerPost;
    const double wanted = this->Count == 3 ? std::round(position) - 1.0 : 0.0;
    this->First = static_cast<int>(std::clamp(wanted, 0.0, double(nodes - this->Count)));
    const double t = position - this->First;
    if (this->Count == 3)
    {
      this->Set(0, 0.5 * (t - 1.0) * (t - 2.0), (t - 1.5) * nodesPerPost);
      this->Set(1, t * (2.0 - t), (2.0 - 2.0 * t) * nodesPerPost);
      this->Set(2, 0.5 * t * (t - 1.0), (t - 0.5) * nodesPerPost);
    }
    else
    {
      this->Set(0, 1.0 - t, -nodesPerPost);
      this->Set(1, t, nodesPerPost);
    }
  }

private:
  void Set(int node, double weight, double slope)
  {
    this->Weight[node] = weight;
    this->Slope[node] = slope;
  }
};

/// Place of a post, and how its normal (radians) or, after FrameAt, its place (metres) changes from
/// post to post.
struct LocalFrame : PostSteps
{
  double Longitude = 0.0, Latitude = 0.0; // degrees
};

/// A value interpolated on the lattice, with its derivatives per column and per row.
struct Interpolated
{
  double Value = 0.0, PerColumn = 0.0, PerRow = 0.0;

  void Add(double value, const Stencil& across, int i, const Stencil& along, int j)
  {
    this->Value += value * across.Weight[i] * along.Weight[j];
    this->PerColumn += value * across.Slope[i] * along.Weight[j];
    this->PerRow += value * across.Weight[i] * along.Slope[j];
  }
};

void Check(const Georeference& place)
{
  if (!place.OnBody())
  {
    throw std::invalid_argument(
      "the height field has no place on a body; give its file a coordinate reference system");
  }
  const std::size_t nodes =
    static_cast<std::size_t>(place.LatticeColumns) * static_cast<std::size_t>(place.LatticeRows);
  if (place.Columns < 2 || place.Rows < 2 || place.LatticeColumns < 2 || place.LatticeRows < 2 ||
    place.Longitude.size() != nodes || place.Latitude.size() != nodes)
  {
    throw std::invalid_argument("the lattice of " + std::to_string(place.LatticeColumns) + " x " +
      std::to_string(place.LatticeRows) + " nodes does not fit its " +
      std::to_string(place.Longitude.size()) +
      " longitudes and the posts; give at least 2 x 2 of each");
  }
}

std::size_t NodeIndex(const Georeference& place, int column, int row)
{
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(place.LatticeColumns) +
    static_cast<std::size_t>(column);
}

/// Returns true if three columns and three rows of nodes share their longitudes along the columns
/// and their latitudes along the rows.
bool AreGraticule(
  const Georeference& place, const std::array<int, 3>& columns, const std::array<int, 3>& rows)
{
  for (const int row : rows)
  {
    for (const int column : columns)
    {
      const std::size_t node = NodeIndex(place, column, row);
      const std::size_t below = NodeIndex(place, column, rows[0]);
      const std::size_t left = NodeIndex(place, columns[0], row);
      // Negated so that NaN does not count as equal.
      if (!(std::abs(place.Longitude[node] - place.Longitude[below]) <= SameDegrees) ||
        !(std::abs(place.Latitude[node] - place.Latitude[left]) <= SameDegrees))
      {
        return false;
      }
    }
  }
  return true;
}

std::array<int, 3> NodesOf(const Stencil& stencil)
{
  const int last = stencil.First + stencil.Count - 1;
  return { { stencil.First, stencil.First + stencil.Count / 2, last } };
}

/// Interpolates longitude and latitude themselves. This is exact on geographic rasters, poles
/// included.
void InterpolateAngles(
  const Georeference& place, const Stencil& across, const Stencil& along, LocalFrame& frame)
{
  Interpolated longitude, latitude;
  for (int j = 0; j < along.Count; ++j)
  {
    for (int i = 0; i < across.Count; ++i)
    {
      const std::size_t node = NodeIndex(place, across.First + i, along.First + j);
      longitude.Add(place.Longitude[node], across, i, along, j);
      latitude.Add(place.Latitude[node], across, i, along, j);
    }
  }
  frame.Longitude = longitude.Value;
  frame.Latitude = latitude.Value;
  const double east = std::cos(latitude.Value * RadiansPerDegree) * RadiansPerDegree;
  frame.EastPerColumn = east * longitude.PerColumn;
  frame.EastPerRow = east * longitude.PerRow;
  frame.NorthPerColumn = RadiansPerDegree * latitude.PerColumn;
  frame.NorthPerRow = RadiansPerDegree * latitude.PerRow;
}

/// Interpolates the unit normals of the ellipsoid, which are smooth over poles and the
/// antimeridian.
void InterpolateNormals(
  const Georeference& place, const Stencil& across, const Stencil& along, LocalFrame& frame)
{
  Interpolated normal[3];
  double nearestWeight = 0.0, nearestLongitude = 0.0;
  for (int j = 0; j < along.Count; ++j)
  {
    for (int i = 0; i < across.Count; ++i)
    {
      const std::size_t node = NodeIndex(place, across.First + i, along.First + j);
      const double lambda = place.Longitude[node] * RadiansPerDegree;
      const double phi = place.Latitude[node] * RadiansPerDegree;
      normal[0].Add(std::cos(phi) * std::cos(lambda), across, i, along, j);
      normal[1].Add(std::cos(phi) * std::sin(lambda), across, i, along, j);
      normal[2].Add(std::sin(phi), across, i, along, j);
      const double weight = across.Weight[i] * along.Weight[j];
      if (weight > nearestWeight)
      {
        nearestWeight = weight;
        nearestLongitude = place.Longitude[node];
      }
    }
  }
  const double x = normal[0].Value, y = normal[1].Value, z = normal[2].Value;
  const double outward = std::hypot(x, y), length = std::hypot(outward, z);
  const double cosLambda = outward > 0.0 ? x / outward : 1.0;
  const double sinLambda = outward > 0.0 ? y / outward : 0.0;
  const double cosPhi = outward / length, sinPhi = z / length;

  const double longitude = std::atan2(y, x) * DegreesPerRadian;
  frame.Longitude = longitude + 360.0 * std::round((nearestLongitude - longitude) / 360.0);
  frame.Latitude = std::atan2(z, outward) * DegreesPerRadian;

  const auto east = [&](double Interpolated::*per)
  { return (cosLambda * (normal[1].*per) - sinLambda * (normal[0].*per)) / length; };
  const auto north = [&](double Interpolated::*per)
  {
    const double outwardPer = cosLambda * (normal[0].*per) + sinLambda * (normal[1].*per);
    return (cosPhi * (normal[2].*per) - sinPhi * outwardPer) / length;
  };
  frame.EastPerColumn = east(&Interpolated::PerColumn);
  frame.EastPerRow = east(&Interpolated::PerRow);
  frame.NorthPerColumn = north(&Interpolated::PerColumn);
  frame.NorthPerRow = north(&Interpolated::PerRow);
}

LocalFrame FrameAt(const Georeference& place, double column, double row)
{
  Check(place);
  const Stencil across(column, place.Columns, place.LatticeColumns);
  const Stencil along(row, place.Rows, place.LatticeRows);

  LocalFrame frame;
  const bool graticule = AreGraticule(place, NodesOf(across), NodesOf(along));
  (graticule ? InterpolateAngles : InterpolateNormals)(place, across, along, frame);
  if (!std::isfinite(frame.Longitude) || !std::isfinite(frame.Latitude))
  {
    throw std::invalid_argument("post " + std::to_string(column) + "," + std::to_string(row) +
      " has no longitude and latitude; cut the raster to where its map is defined");
  }

  // Radii of curvature N along the parallel and M along the meridian.
  const double sinPhi = std::sin(frame.Latitude * RadiansPerDegree);
  const double e2 = place.Flattening * (2.0 - place.Flattening);
  const double w2 = 1.0 - e2 * sinPhi * sinPhi;
  const double normalRadius = place.EquatorialRadius / std::sqrt(w2);
  const double meridianRadius = normalRadius * (1.0 - e2) / w2;
  frame.EastPerColumn *= normalRadius;
  frame.EastPerRow *= normalRadius;
  frame.NorthPerColumn *= meridianRadius;
  frame.NorthPerRow *= meridianRadius;
  return frame;
}

/// Converts the frame from steps per post to steps per metre of the image, so that a map without
/// distortion gives a rotation matrix. On a graticule and for rasters in degrees, the lengths of
/// the image are the true ones; elsewhere only their ratio on the map matters.
void ScaleToImage(const Georeference& place, LocalFrame& frame)
{
  double x = std::hypot(frame.EastPerColumn, frame.NorthPerColumn);
  double y = std::hypot(frame.EastPerRow, frame.NorthPerRow);
  if (!place.InDegrees && place.HasGeoTransform && !place.FollowsGraticule())
  {
    x = std::abs(place.GeoTransform[1]);
    y = std::abs(place.GeoTransform[5]);
  }
  frame.EastPerColumn /= x;
  frame.NorthPerColumn /= x;
  frame.EastPerRow /= y;
  frame.NorthPerRow /= y;
}

} // namespace

void Georeference::LonLatAt(double column, double row, double& longitude, double& latitude) const
{
  const LocalFrame frame = FrameAt(*this, column, row);
  longitude = frame.Longitude;
  latitude = frame.Latitude;
}

PostSteps Georeference::StepsAt(double column, double row) const
{
  return FrameAt(*this, column, row);
}

bool Georeference::FollowsGraticule() const
{
  Check(*this);
  const int columns = this->LatticeColumns, rows = this->LatticeRows;
  return AreGraticule(*this, { { 0, columns / 2, columns - 1 } }, { { 0, rows / 2, rows - 1 } });
}

double Georeference::ConvergenceAt(double column, double row) const
{
  LocalFrame frame = FrameAt(*this, column, row);
  ScaleToImage(*this, frame);
  // A rotation by c has EastPerRow = -NorthPerColumn = sin c and NorthPerRow = EastPerColumn = cos
  // c. For other matrices, the means of these elements give the nearest rotation.
  return std::atan2(
           frame.EastPerRow - frame.NorthPerColumn, frame.NorthPerRow + frame.EastPerColumn) *
    DegreesPerRadian;
}

double Georeference::GridAzimuthAt(double column, double row, double trueAzimuth) const
{
  LocalFrame frame = FrameAt(*this, column, row);
  ScaleToImage(*this, frame);
  const double east = std::sin(trueAzimuth * RadiansPerDegree);
  const double north = std::cos(trueAzimuth * RadiansPerDegree);
  // Cramer's rule. The size of the determinant does not affect the direction, but its sign does.
  const double determinant =
    frame.EastPerColumn * frame.NorthPerRow - frame.EastPerRow * frame.NorthPerColumn;
  const double sign = determinant < 0.0 ? -1.0 : 1.0;
  const double x = sign * (east * frame.NorthPerRow - north * frame.EastPerRow);
  const double y = sign * (north * frame.EastPerColumn - east * frame.NorthPerColumn);
  return AzimuthOf(x, y);
}

double Georeference::TrueAzimuthAt(double column, double row, double gridAzimuth) const
{
  LocalFrame frame = FrameAt(*this, column, row);
  ScaleToImage(*this, frame);
  const double x = std::sin(gridAzimuth * RadiansPerDegree);
  const double y = std::cos(gridAzimuth * RadiansPerDegree);
  return AzimuthOf(x * frame.EastPerColumn + y * frame.EastPerRow,
    x * frame.NorthPerColumn + y * frame.NorthPerRow);
}

double Georeference::GroundAzimuthAt(double column, double row, double trueAzimuth) const
{
  const LocalFrame frame = FrameAt(*this, column, row);
  const double east = std::sin(trueAzimuth * RadiansPerDegree);
  const double north = std::cos(trueAzimuth * RadiansPerDegree);
  // Turned so that the step between rows is the y axis.
  return AzimuthOf(east * frame.NorthPerRow - north * frame.EastPerRow,
    north * frame.NorthPerRow + east * frame.EastPerRow);
}

double Georeference::AxisAzimuthAt(double column, double row, double trueAzimuth) const
{
  return this->GroundAxes ? this->GroundAzimuthAt(column, row, trueAzimuth)
                          : this->GridAzimuthAt(column, row, trueAzimuth);
}

double Georeference::LocalRadius(double latitude) const
{
  if (!(this->EquatorialRadius > 0.0))
  {
    throw std::invalid_argument(
      "the height field has no body; give its file a coordinate reference system");
  }
  const double sinPhi = std::sin(latitude * RadiansPerDegree);
  const double e2 = this->Flattening * (2.0 - this->Flattening);
  return this->EquatorialRadius * std::sqrt(1.0 - e2) / (1.0 - e2 * sinPhi * sinPhi);
}

} // namespace skyline
