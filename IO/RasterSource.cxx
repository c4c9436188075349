// SPDX-License-Identifier: BSD-3-Clause
#include "RasterSource.h"

#include "Geo/LooksLikeDegrees.h"
#include "Geo/RowSpacing.h"
#include "HeightConversion.h"
#include "IoFailure.h"
#include "MissingPosts.h"
#include "Shared/HeightLimits.h"

#include "vtkErrorCode.h"
#include "vtkSetGet.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace skyline
{

namespace
{

/// Number of bytes read from the file in one step: whole rows of blocks, at least one row.
constexpr double StripBytes = 4.0 * 1024 * 1024;

/// The part of a pixel by which a rotation term may move the far corner of the raster. A smaller
/// move is rounding, not rotation.
constexpr double RotationSlack = 1e-3;

/// The VTK type for the values of a band, and whether float holds each of them exactly.
struct BandType
{
  int VtkType = VTK_VOID; ///< VTK_VOID if the values are not real numbers
  bool FitsFloat = false;
};

BandType TypeOf(GDALDataType type)
{
  switch (type)
  {
    case GDT_Byte:
      return { VTK_UNSIGNED_CHAR, true };
#if GDAL_VERSION_NUM >= GDAL_COMPUTE_VERSION(3, 7, 0)
    case GDT_Int8:
      return { VTK_SIGNED_CHAR, true };
#endif
    case GDT_UInt16:
      return { VTK_UNSIGNED_SHORT, true };
    case GDT_Int16:
      return { VTK_SHORT, true };
    case GDT_UInt32:
      return { VTK_UNSIGNED_INT, false };
    case GDT_Int32:
      return { VTK_INT, false };
    case GDT_UInt64:
      return { VTK_UNSIGNED_LONG_LONG, false };
    case GDT_Int64:
      return { VTK_LONG_LONG, false };
#if GDAL_VERSION_NUM >= GDAL_COMPUTE_VERSION(3, 11, 0)
    case GDT_Float16:
#endif
    case GDT_Float32:
      return { VTK_FLOAT, true };
    case GDT_Float64:
      return { VTK_DOUBLE, false };
    default:
      return {};
  }
}

/// True if, seen from above at the centre, the next column lies to the left of the direction to the
/// next row. The posts then show the ground as in a mirror.
bool IsMirrored(const Georeference& place)
{
  const PostSteps steps = place.StepsAt(
    0.5 * static_cast<double>(place.Columns - 1), 0.5 * static_cast<double>(place.Rows - 1));
  return steps.EastPerColumn * steps.NorthPerRow < steps.EastPerRow * steps.NorthPerColumn;
}

GDALDataType GdalTypeOf(int vtkType)
{
  switch (vtkType)
  {
    case VTK_UNSIGNED_CHAR:
      return GDT_Byte;
#if GDAL_VERSION_NUM >= GDAL_COMPUTE_VERSION(3, 7, 0)
    case VTK_SIGNED_CHAR:
      return GDT_Int8;
#endif
    case VTK_UNSIGNED_SHORT:
      return GDT_UInt16;
    case VTK_SHORT:
      return GDT_Int16;
    case VTK_UNSIGNED_INT:
      return GDT_UInt32;
    case VTK_INT:
      return GDT_Int32;
    case VTK_UNSIGNED_LONG_LONG:
      return GDT_UInt64;
    case VTK_LONG_LONG:
      return GDT_Int64;
    case VTK_FLOAT:
      return GDT_Float32;
    default:
      return GDT_Float64;
  }
}

} // namespace

RasterSource::RasterSource(const std::string& file, int band,
  const std::vector<double>& furtherNodata, const SourcePolicy& policy, const std::string& spooled)
  : File(file)
  , Opened(spooled.empty() ? file : spooled)
  , Guard(this->Opened, policy, spooled.empty() ? "" : ".")
  , FurtherNodata(furtherNodata)
{
  this->Open(band);
  this->ReadTransform();
  this->ReadPlace();
  this->CheckSpacing();
  this->ReadValues();
  this->CheckComplaints();
}

void RasterSource::Refuse(const std::string& reason) const
{
  throw IoFailure(vtkErrorCode::FileFormatError, "cannot use '" + this->File + "': " + reason);
}

void RasterSource::ReadTransform()
{
  this->Whole.Columns = this->Columns;
  this->Whole.Rows = this->Rows;

  const OGRSpatialReference* crs = this->Dataset->GetSpatialRef();
  const bool hasCrs = crs && !crs->IsEmpty();
  std::array<double, 6> transform{ { 0, 1, 0, 0, 0, 1 } };
  const std::array<double, 6> none = transform;
  const bool found =
    this->Dataset->GetGeoTransform(transform.data()) == CE_None && (hasCrs || transform != none);
  if (!found)
  {
    this->RefuseOtherPlaces();
    if (hasCrs)
    {
      this->Refuse("it has a CRS but no geotransform; give its corners (gdal_edit.py -a_ullr)");
    }
    this->Doubts.push_back(
      { "'" + this->File + "' has no geotransform", "posts 1 m apart", "gdal_edit.py -a_ullr" });
    return;
  }

  for (const double number : transform)
  {
    if (!std::isfinite(number))
    {
      this->Refuse(
        "its geotransform has a number that is not finite; correct it (gdal_edit.py -a_ullr)");
    }
  }
  if (std::abs(transform[2]) * this->Rows > RotationSlack * std::abs(transform[1]) ||
    std::abs(transform[4]) * this->Columns > RotationSlack * std::abs(transform[5]))
  {
    this->Refuse("it is rotated or sheared (geotransform " + std::to_string(transform[1]) + ", " +
      std::to_string(transform[2]) + ", " + std::to_string(transform[4]) + ", " +
      std::to_string(transform[5]) + "); warp it to a north-up raster (gdalwarp)");
  }
  if (transform[1] == 0.0 || transform[5] == 0.0)
  {
    this->Refuse("its pixels have no size; correct it (gdal_edit.py -a_ullr)");
  }
  transform[2] = 0.0;
  transform[4] = 0.0;
  this->Whole.GeoTransform = transform;
  this->Whole.HasGeoTransform = true;
  if (hasCrs)
  {
    this->Crs = CoordinateSystem(*crs, this->File);
  }
}

/// Refuses a raster whose position is given, but not by a geotransform.
void RasterSource::RefuseOtherPlaces() const
{
  if (this->Dataset->GetGCPCount() > 0)
  {
    this->Refuse("it is placed by ground control points; warp it to a north-up raster (gdalwarp)");
  }
  if (this->Dataset->GetMetadata("RPC"))
  {
    this->Refuse("it is placed by rational polynomials (RPC); warp it to a north-up raster "
                 "(gdalwarp -rpc)");
  }
  if (this->Dataset->GetMetadata("GEOLOCATION"))
  {
    this->Refuse(
      "it is placed by arrays of coordinates (curvilinear); warp it to a north-up raster "
      "(gdalwarp -geoloc)");
  }
}

void RasterSource::CheckSpacing() const
{
  for (const double spacing : this->Spacing)
  {
    if (!(spacing >= LeastSpacing && spacing <= GreatestSpacing))
    {
      std::array<char, 32> text{};
      std::snprintf(text.data(), text.size(), "%.6g", spacing);
      this->Refuse("its posts are " + std::string(text.data()) +
        " m apart, but must be 1e-9 to 1e9 m apart; correct its corners (gdal_edit.py -a_ullr)");
    }
  }
}

void RasterSource::ReadPlace()
{
  if (!this->Whole.HasGeoTransform)
  {
    return;
  }
  // From here on, the geotransform is that of the north-up raster with the same posts.
  std::array<double, 6>& transform = this->Whole.GeoTransform;
  this->MirroredX = (transform[1] < 0.0) != this->Crs.PointsSouthWest();
  this->SouthUp = (transform[5] > 0.0) != this->Crs.PointsSouthWest();
  const auto mirror = [&]()
  {
    transform[0] += this->Columns * transform[1];
    transform[1] = -transform[1];
  };
  if (this->MirroredX)
  {
    mirror();
  }
  if (this->SouthUp)
  {
    transform[3] += this->Rows * transform[5];
    transform[5] = -transform[5];
  }
  const OGRSpatialReference* crs = this->Dataset->GetSpatialRef();
  if (crs && !crs->IsEmpty())
  {
    this->Crs.Place(this->Whole);
    if (this->Whole.OnBody() && IsMirrored(this->Whole))
    {
      // A CRS whose axes point south and west (Krovak) must be mirrored to show the ground from
      // above.
      this->MirroredX = !this->MirroredX;
      mirror();
      this->Crs.Place(this->Whole);
    }
  }

  const double unit = this->Crs.GetUnit();
  PostSpacing spacing;
  try
  {
    spacing = ComputeRowSpacing(this->Whole, std::abs(transform[1]) * unit,
      std::abs(transform[5]) * unit, this->Crs.GetStepUnit());
  }
  catch (const std::invalid_argument& reason)
  {
    this->Refuse(reason.what());
  }
  this->Spacing = { { spacing.X, spacing.Y } };
  if (!this->Crs.IsGeographic())
  {
    // Columns and rows increase with the coordinates of the image, whatever the directions of the
    // map.
    const double metresX = transform[1] < 0.0 ? -unit : unit;
    const double metresY = transform[5] > 0.0 ? -unit : unit;
    this->Origin = { { (transform[0] + 0.5 * transform[1]) * metresX,
      (transform[3] + (this->Rows - 0.5) * transform[5]) * metresY } };
  }
}

void RasterSource::ReadValues()
{
  const GDALDataType gdalType = this->Band->GetRasterDataType();
  const BandType type = TypeOf(gdalType);
  if (type.VtkType == VTK_VOID)
  {
    this->Refuse(std::string("its values are ") + GDALGetDataTypeName(gdalType) +
      ", not heights; convert them to real numbers (gdal_translate -ot Float32)");
  }

  const HeightConversion conversion =
    ReadHeightConversion(*this->Dataset, *this->Band, this->Crs, this->File, this->Doubts);
  this->Scale = conversion.Scale;
  this->Offset = conversion.Offset;

  int found = 0;
  if (gdalType == GDT_Int64)
  {
    this->Nodata = static_cast<double>(this->Band->GetNoDataValueAsInt64(&found));
  }
  else if (gdalType == GDT_UInt64)
  {
    this->Nodata = static_cast<double>(this->Band->GetNoDataValueAsUInt64(&found));
  }
  else
  {
    this->Nodata = this->Band->GetNoDataValue(&found);
  }
  this->DeclaresNodata = found != 0;
  const int flags = this->Band->GetMaskFlags();
  this->HasMask = !(flags & GMF_ALL_VALID) && flags != GMF_NODATA;

  this->Plain = this->Scale == 1.0 && this->Offset == 0.0 && !this->DeclaresNodata &&
    this->FurtherNodata.empty() && !this->HasMask;
  const bool real = type.VtkType == VTK_FLOAT || type.VtkType == VTK_DOUBLE;
  this->VtkType = this->Plain || real ? type.VtkType : (type.FitsFloat ? VTK_FLOAT : VTK_DOUBLE);
}

std::vector<std::string> RasterSource::GetFiles() const
{
  std::vector<std::string> files{ this->File };
  const CPLStringList listed(this->Dataset->GetFileList());
  for (int i = 0; i < listed.Count(); ++i)
  {
    files.emplace_back(listed[i]);
  }
  return files;
}

Georeference RasterSource::GetGeoreference(const PostWindow& window) const
{
  if (window.Columns == this->Columns && window.Rows == this->Rows)
  {
    return this->Whole;
  }
  Georeference part = this->Whole;
  part.Columns = window.Columns;
  part.Rows = window.Rows;
  if (!part.HasGeoTransform)
  {
    return part;
  }
  const int rowsAbove = this->Rows - window.RowBegin - window.Rows;
  part.GeoTransform[0] += window.ColumnBegin * part.GeoTransform[1];
  part.GeoTransform[3] += rowsAbove * part.GeoTransform[5];
  if (part.OnBody())
  {
    this->Crs.Place(part);
  }
  if (!part.RowSpacingX.empty())
  {
    const auto slice = [&](std::vector<double>& rows)
    {
      const auto begin = rows.begin() + window.RowBegin;
      rows = std::vector<double>(begin, begin + window.Rows);
    };
    slice(part.RowSpacingX);
    slice(part.RowSpacingY);
  }
  return part;
}

void RasterSource::Read(const PostWindow& window, void* heights, const ProgressFunction& progress)
{
  switch (this->VtkType)
  {
    vtkTemplateMacro(this->ReadAs(window, static_cast<VTK_TT*>(heights), progress));
    default:
      break;
  }
  this->CheckComplaints();
}

/// Converts raw values to metres in place and adds the existing heights to the census. Returns
/// false if no value is a height.
template <typename T, typename Missing>
bool RasterSource::Convert(
  T* heights, const unsigned char* mask, std::size_t count, Missing& missing, HeightCensus& census)
{
  bool any = false;
  for (std::size_t i = 0; i < count; ++i)
  {
    const T raw = heights[i];
    if constexpr (std::is_floating_point_v<T>)
    {
      const bool declared = missing(raw);
      if (declared || (mask && mask[i] == 0))
      {
        heights[i] = std::numeric_limits<T>::quiet_NaN();
        continue;
      }
      census.Add(static_cast<double>(raw));
      const double height = static_cast<double>(raw) * this->Scale + this->Offset;
      const bool ground = std::abs(height) <= GreatestHeight;
      heights[i] = ground ? static_cast<T>(height) : std::numeric_limits<T>::quiet_NaN();
      any = any || ground;
    }
    else
    {
      census.Add(static_cast<double>(raw));
      any = true;
    }
  }
  return any;
}

void RasterSource::DoubtHeights(const HeightCensus& census)
{
  const GDALDataType type = this->Band->GetRasterDataType();
  const HeightCensus::Findings found =
    census.Judge("'" + this->File + "'", this->Scale, type == GDT_Float32);
  this->Doubts.insert(this->Doubts.end(), found.Doubts.begin(), found.Doubts.end());
  if (!found.Any || !this->Whole.HasGeoTransform || !this->Whole.Crs.empty())
  {
    return;
  }
  const std::array<double, 6>& transform = this->Whole.GeoTransform;
  const double west = transform[0], east = transform[0] + this->Columns * transform[1];
  const double north = transform[3], south = transform[3] + this->Rows * transform[5];
  const double relief = (found.Highest - found.Lowest) * std::abs(this->Scale);
  if (LooksLikeDegrees(west, south, east, north, relief))
  {
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(),
      "looks like degrees (x %.6g to %.6g, y %.6g to %.6g) with a relief of %.6g m", west, east,
      south, north, relief);
    this->Doubts.push_back({ "'" + this->File + "' has no CRS and " + text.data(),
      "x and y in metres", "gdal_edit.py -a_srs EPSG:4326" });
  }
}

void RasterSource::ReadStrip(
  int column, int row, int columns, int rows, void* heights, unsigned char* mask)
{
  CPLErr failed = this->Band->RasterIO(GF_Read, column, row, columns, rows, heights, columns, rows,
    GdalTypeOf(this->VtkType), 0, 0, nullptr);
  if (failed == CE_None && this->HasMask)
  {
    failed = this->Band->GetMaskBand()->RasterIO(
      GF_Read, column, row, columns, rows, mask, columns, rows, GDT_Byte, 0, 0, nullptr);
  }
  if (failed != CE_None || this->Errors.Any())
  {
    this->CheckRefusal();
    throw IoFailure(vtkErrorCode::PrematureEndOfFileError,
      "cannot read row " + std::to_string(row) + " of '" + this->File +
        "': " + this->Errors.First() + "; the file may be damaged, fetch it again");
  }
}

template <typename T>
void RasterSource::ReadAs(const PostWindow& window, T* heights, const ProgressFunction& progress)
{
  const int fileColumn =
    this->MirroredX ? this->Columns - window.ColumnBegin - window.Columns : window.ColumnBegin;
  const int fileRow = this->SouthUp ? window.RowBegin : this->Rows - window.RowBegin - window.Rows;
  const int fileEnd = fileRow + window.Rows;
  const auto columns = static_cast<std::size_t>(window.Columns);

  int blockColumns = 1, blockRows = 1;
  this->Band->GetBlockSize(&blockColumns, &blockRows);
  const double wanted = StripBytes / (static_cast<double>(columns) * sizeof(T));
  const auto blocks = static_cast<std::int64_t>(std::clamp(wanted / blockRows, 1.0, 1e6));
  const auto stripRows = static_cast<int>(std::min<std::int64_t>(blocks * blockRows, window.Rows));
  std::vector<T> strip(columns * static_cast<std::size_t>(stripRows));
  std::vector<unsigned char> mask(this->HasMask ? strip.size() : 0);

  std::vector<double> declared = this->FurtherNodata;
  if (this->DeclaresNodata)
  {
    declared.push_back(this->Nodata);
  }
  using Real = std::conditional_t<std::is_same_v<T, double>, double, float>;
  MissingPosts<Real> missing(declared);
  HeightCensus census;

  this->Errors.Clear(); // failures on opening did not prevent it
  bool anyHeight = false;
  for (int row = fileRow; row < fileEnd;)
  {
    // A strip ends at the end of a block, so that no block is read twice.
    const std::int64_t blockEnd = (row / blockRows + blocks) * blockRows;
    const int end = static_cast<int>(
      std::min<std::int64_t>({ fileEnd, static_cast<std::int64_t>(row) + stripRows, blockEnd }));
    const int rows = end - row;
    this->ReadStrip(fileColumn, row, window.Columns, rows, strip.data(), mask.data());

    const std::size_t count = columns * static_cast<std::size_t>(rows);
    anyHeight =
      this->Convert(strip.data(), this->HasMask ? mask.data() : nullptr, count, missing, census) ||
      anyHeight;
    for (int line = 0; line < rows; ++line)
    {
      const T* from = strip.data() + columns * static_cast<std::size_t>(line);
      const int done = row + line - fileRow;
      const int imageRow = this->SouthUp ? done : window.Rows - 1 - done;
      T* to = heights + columns * static_cast<std::size_t>(imageRow);
      if (this->MirroredX)
      {
        std::reverse_copy(from, from + columns, to);
      }
      else
      {
        std::copy(from, from + columns, to);
      }
    }
    row = end;
    if (!progress(static_cast<double>(row - fileRow) / window.Rows))
    {
      throw IoAborted();
    }
  }

  const bool whole = window.Columns == this->Columns && window.Rows == this->Rows;
  if (whole && !anyHeight)
  {
    this->Refuse("all its " + std::to_string(this->Columns) + " x " + std::to_string(this->Rows) +
      " posts are missing (nodata); choose another band or file");
  }
  for (std::size_t i = 0; whole && i < this->FurtherNodata.size(); ++i)
  {
    if (missing.GetFound(i) == 0)
    {
      this->Doubts.push_back({ "no post of '" + this->File + "' has the nodata value " +
          HeightCensus::Text(this->FurtherNodata[i], false),
        "it marks no missing post", "" });
    }
  }
  this->DoubtHeights(census);
}

} // namespace skyline
