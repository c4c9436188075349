// SPDX-License-Identifier: BSD-3-Clause
#include "CoordinateSystem.h"

#include "GdalErrors.h"
#include "IoFailure.h"
#include "LengthUnit.h"
#include "Shared/Constants.h"

#include "vtkErrorCode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <memory>
#include <sstream>

namespace skyline
{

namespace
{

/// A body is the Earth if its equatorial radius (metres) differs from the Earth's by less than this
/// relative tolerance. Ellipsoids of the Earth differ by 0.02 %; the most similar body, Venus, by 5
/// %.
constexpr double EarthRadius = 6378137.0;
constexpr double EarthRadiusTolerance = 0.01;

/// The part of a pixel by which rounding in a raster's georeference may place a post beyond a pole.
constexpr double PoleSlack = 1e-3;

std::string PercentText(double part)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << 100.0 * part << " %";
  return text.str();
}

[[noreturn]] void Refuse(const std::string& file, const std::string& reason)
{
  throw IoFailure(vtkErrorCode::FileFormatError, "cannot use '" + file + "': " + reason);
}

std::string NameOf(const OGRSpatialReference& crs)
{
  const char* name = crs.GetName();
  return name ? name : "unnamed";
}

std::string WktOf(const OGRSpatialReference& crs)
{
  const char* const options[] = { "FORMAT=WKT2_2019", "MULTILINE=NO", nullptr };
  char* text = nullptr;
  std::string wkt;
  if (crs.exportToWkt(&text, options) == OGRERR_NONE && text)
  {
    wkt = text;
  }
  CPLFree(text);
  return wkt;
}

/// The greatest number of lattice nodes along a side. A map of the whole globe needs 345.
constexpr int LastLatticeNodes = 513;

/// A raster whose longer side is shorter than this (metres) is not checked. The coarsest lattice is
/// exact for it up to rounding, and the check would only compare the rounding errors of longitudes.
constexpr double ShortestChecked = 1000.0;

std::array<double, 3> NormalAt(double longitude, double latitude)
{
  const double lambda = longitude * RadiansPerDegree, phi = latitude * RadiansPerDegree;
  return { { std::cos(phi) * std::cos(lambda), std::cos(phi) * std::sin(lambda), std::sin(phi) } };
}

/// Adds the multiple of 360 degrees that brings `longitude` closest to `neighbour`.
double Continued(double longitude, double neighbour)
{
  return longitude + 360.0 * std::round((neighbour - longitude) / 360.0);
}

} // namespace

CoordinateSystem::CoordinateSystem(const OGRSpatialReference& crs, const std::string& file)
  : File(file)
  , Wkt(WktOf(crs))
  , Horizontal(crs)
{
  if (this->Horizontal.IsCompound())
  {
    this->Horizontal.StripVertical();
  }
  this->Horizontal.DemoteTo2D(nullptr);
  this->Horizontal.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);

  this->Geographic = this->Horizontal.IsGeographic() != 0;
  this->Derived = this->Geographic && this->Horizontal.IsDerivedGeographic() != 0;
  this->OnBody = this->Geographic || this->Horizontal.IsProjected() != 0;
  if (!this->OnBody && !this->Horizontal.IsLocal())
  {
    Refuse(file,
      "its CRS '" + NameOf(crs) +
        "' is neither geographic nor projected; warp it to a map first (gdalwarp -t_srs)");
  }
  this->ReadAxes();
  this->ReadUnits(crs);
}

void CoordinateSystem::ReadAxes()
{
  OGRAxisOrientation axes[2] = { OAO_Other, OAO_Other };
  this->Horizontal.GetAxis(nullptr, 0, &axes[0]);
  this->Horizontal.GetAxis(nullptr, 1, &axes[1]);
  if (this->Geographic && (axes[0] == OAO_West || axes[1] == OAO_West))
  {
    Refuse(this->File,
      "the longitudes of its CRS '" + NameOf(this->Horizontal) +
        "' grow to the west; assign the CRS of the same body that counts to the east "
        "(gdal_edit.py -a_srs)");
  }
  this->SouthWest = axes[0] == OAO_West && axes[1] == OAO_South;
}

void CoordinateSystem::ReadUnits(const OGRSpatialReference& whole)
{
  const char* name = nullptr;
  if (this->Geographic)
  {
    this->Unit = this->Horizontal.GetAngularUnits(&name) * DegreesPerRadian;
  }
  else
  {
    this->Unit = this->Horizontal.GetLinearUnits(&name);
  }
  const std::string unit = name ? name : "";
  double metres = 0.0;
  // If the unit is missing, GDAL gives the factor 1 and a name that is not a length.
  const bool nameless =
    !this->Geographic && this->Unit == 1.0 && ReadUnitName(unit, metres) != UnitName::Length;
  if (!(this->Unit > 0.0) || !std::isfinite(this->Unit) || nameless)
  {
    Refuse(this->File,
      "its CRS '" + NameOf(this->Horizontal) + "' has the unit '" + unit +
        "', whose length is not known; assign a CRS with a unit (gdal_edit.py -a_srs)");
  }

  // The third axis belongs to a compound or a three-dimensional CRS.
  if (whole.GetAxesCount() > 2)
  {
    OGRAxisOrientation axis = OAO_Other;
    whole.GetAxis(nullptr, 2, &axis, &this->VerticalUnit);
    this->Depths = axis == OAO_Down;
    if (!(this->VerticalUnit > 0.0) || !std::isfinite(this->VerticalUnit))
    {
      Refuse(this->File,
        "the vertical part of its CRS '" + NameOf(whole) +
          "' has a unit whose length is not known; assign a CRS with a unit (gdal_edit.py -a_srs)");
    }
  }
}

void CoordinateSystem::Place(Georeference& georeference) const
{
  georeference.Crs = this->Wkt;
  if (!this->OnBody)
  {
    return;
  }
  OGRErr failed = OGRERR_NONE;
  georeference.EquatorialRadius = this->Horizontal.GetSemiMajor(&failed);
  if (failed != OGRERR_NONE || !(georeference.EquatorialRadius > 0.0))
  {
    Refuse(this->File,
      "its CRS '" + NameOf(this->Horizontal) +
        "' has no ellipsoid; assign a CRS with a datum (gdal_edit.py -a_srs)");
  }
  const double inverse = this->Horizontal.GetInvFlattening(&failed);
  georeference.Flattening = inverse > 0.0 ? 1.0 / inverse : 0.0;
  georeference.Earth =
    std::abs(georeference.EquatorialRadius / EarthRadius - 1.0) < EarthRadiusTolerance;
  this->FillLattice(georeference);
}

void CoordinateSystem::FillLattice(Georeference& georeference) const
{
  // A geographic CRS in degrees on the same ellipsoid, without a datum. Longitudes then count from
  // Greenwich (or from the prime meridian of the body), and there is no datum shift, whatever the
  // units and the prime meridian of the CRS are.
  OGRSpatialReference degrees;
  degrees.SetGeogCS("own", "own", "own", georeference.EquatorialRadius,
    georeference.Flattening > 0.0 ? 1.0 / georeference.Flattening : 0.0);
  degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);

  GdalErrors errors;
  const std::unique_ptr<OGRCoordinateTransformation> toDegrees(
    OGRCreateCoordinateTransformation(&this->Horizontal, &degrees));
  if (!toDegrees)
  {
    Refuse(this->File,
      "its CRS '" + NameOf(this->Horizontal) +
        "' cannot be converted to longitudes: " + errors.First());
  }
  // In a geographic CRS, longitudes and latitudes are linear in x and y, so that interpolation is
  // exact.
  const bool exact = this->Geographic && !this->Derived;
  for (int nodes = DefaultLatticeNodes;; nodes = 2 * nodes - 1)
  {
    this->FillNodes(georeference, nodes, *toDegrees);
    if (exact || this->IsFine(georeference, *toDegrees))
    {
      return;
    }
    if (nodes >= LastLatticeNodes)
    {
      Refuse(this->File,
        "its map '" + NameOf(this->Horizontal) +
          "' is torn or folded inside the raster: lengths change "
          "by more than " +
          PercentText(LatticeTolerance) + " between two of " + std::to_string(nodes) +
          " places along a side; cut the raster to one side of the tear (gdalwarp -te) or warp it to "
          "a local map such as UTM (gdalwarp -t_srs)");
    }
  }
}

void CoordinateSystem::ToDegrees(const Georeference& georeference,
  OGRCoordinateTransformation& toDegrees, std::vector<double>& columns,
  std::vector<double>& rows) const
{
  const std::array<double, 6>& transform = georeference.GeoTransform;
  const double pole = 90.0 / this->Unit;
  std::vector<double>& x = columns;
  std::vector<double>& y = rows;
  for (std::size_t point = 0; point < x.size(); ++point)
  {
    x[point] = transform[0] + (columns[point] + 0.5) * transform[1];
    y[point] =
      transform[3] + (static_cast<double>(georeference.Rows) - 0.5 - rows[point]) * transform[5];
    const double over = std::abs(y[point]) - pole;
    if (this->Geographic && over > 0.0 && over < PoleSlack * std::abs(transform[5]))
    {
      y[point] = std::copysign(pole, y[point]);
    }
  }
  const std::vector<double> mapX = x;
  const std::vector<double> mapY = y;
  std::vector<int> placed(x.size(), 0);
  toDegrees.Transform(static_cast<int>(x.size()), x.data(), y.data(), nullptr, placed.data());
  for (std::size_t point = 0; point < x.size(); ++point)
  {
    if (!placed[point] || !std::isfinite(x[point]) || !(std::abs(y[point]) <= 90.0))
    {
      Refuse(this->File,
        "the point (" + std::to_string(mapX[point]) + ", " + std::to_string(mapY[point]) +
          ") has no longitude and latitude in its CRS '" + NameOf(this->Horizontal) +
          "'; cut the raster to where the map is defined (gdalwarp -te) or correct its CRS");
    }
  }
}

void CoordinateSystem::FillNodes(
  Georeference& georeference, int nodes, OGRCoordinateTransformation& toDegrees) const
{
  std::vector<double> x, y;
  for (int j = 0; j < nodes; ++j)
  {
    for (int i = 0; i < nodes; ++i)
    {
      x.push_back(i * static_cast<double>(georeference.Columns - 1) / (nodes - 1));
      y.push_back(j * static_cast<double>(georeference.Rows - 1) / (nodes - 1));
    }
  }
  this->ToDegrees(georeference, toDegrees, x, y);
  const auto side = static_cast<std::size_t>(nodes);
  for (std::size_t node = 1; node < x.size(); ++node)
  {
    x[node] = Continued(x[node], x[node % side == 0 ? node - side : node - 1]);
  }
  georeference.LatticeColumns = nodes;
  georeference.LatticeRows = nodes;
  georeference.Longitude = std::move(x);
  georeference.Latitude = std::move(y);
}

bool CoordinateSystem::IsFine(
  const Georeference& georeference, OGRCoordinateTransformation& toDegrees) const
{
  const PostSteps middle = georeference.StepsAt(0.5 * static_cast<double>(georeference.Columns - 1),
    0.5 * static_cast<double>(georeference.Rows - 1));
  const double width = std::hypot(middle.EastPerColumn, middle.NorthPerColumn) *
    static_cast<double>(georeference.Columns - 1);
  const double height =
    std::hypot(middle.EastPerRow, middle.NorthPerRow) * static_cast<double>(georeference.Rows - 1);
  if (std::max(width, height) < ShortestChecked)
  {
    return true;
  }
  // Compare steps across the nodes, where the error of the interpolated steps is greatest.
  const int nodes = georeference.LatticeColumns;
  const double cellX = static_cast<double>(georeference.Columns - 1) / (nodes - 1);
  const double cellY = static_cast<double>(georeference.Rows - 1) / (nodes - 1);
  const int stride = (nodes - 1) / (DefaultLatticeNodes - 1);
  std::vector<double> columns, rows;
  for (int j = 0; j < nodes; j += stride)
  {
    for (int i = 0; i < nodes; i += stride)
    {
      const double column = std::clamp(i * 1.0, 0.125, nodes - 1.125) * cellX;
      const double row = std::clamp(j * 1.0, 0.125, nodes - 1.125) * cellY;
      const double reachX = 0.125 * cellX, reachY = 0.125 * cellY;
      columns.insert(columns.end(), { column - reachX, column + reachX, column, column });
      rows.insert(rows.end(), { row, row, row - reachY, row + reachY });
    }
  }
  std::vector<double> longitude = columns, latitude = rows;
  this->ToDegrees(georeference, toDegrees, longitude, latitude);
  for (std::size_t i = 0; i < columns.size(); i += 2)
  {
    std::array<double, 3> truth = NormalAt(longitude[i + 1], latitude[i + 1]);
    std::array<double, 3> found{};
    const std::array<double, 3> before = NormalAt(longitude[i], latitude[i]);
    double lambda = 0.0, phi = 0.0;
    georeference.LonLatAt(columns[i + 1], rows[i + 1], lambda, phi);
    found = NormalAt(lambda, phi);
    georeference.LonLatAt(columns[i], rows[i], lambda, phi);
    const std::array<double, 3> foundBefore = NormalAt(lambda, phi);
    double length = 0.0, error = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double step = truth[k] - before[k];
      const double off = found[k] - foundBefore[k] - step;
      length += step * step;
      error += off * off;
    }
    // At a pole, where all columns meet, the step is 0 and cannot be compared.
    const double whole = std::max(width, height) / georeference.EquatorialRadius;
    if (error > LatticeTolerance * LatticeTolerance * length && std::sqrt(length) > 1e-6 * whole)
    {
      return false;
    }
  }
  return true;
}

} // namespace skyline
