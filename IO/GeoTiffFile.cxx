// SPDX-License-Identifier: BSD-3-Clause
#include "GeoTiffFile.h"

#include "AtomicFile.h"
#include "BandRows.h"
#include "Batches.h"
#include "CheckedVsi.h"
#include "Data/ImageGeoreference.h"
#include "GdalDataset.h"
#include "GdalErrors.h"
#include "GeoTiffCheck.h"
#include "GeoTiffRows.h"
#include "TiffBlockTable.h"

#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <limits>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace skyline
{

namespace
{

/// A raster with more posts than this along both sides is written in tiles.
constexpr int TiledFrom = 512;
constexpr int TileSize = 256;

/// Bytes of a strip in a file without tiles, and bytes that are passed to GDAL in one call.
constexpr int StripBytes = 64 * 1024;
constexpr double ChunkBytes = 4.0 * 1024 * 1024;

/// Bytes of a band that one thread packs in one step, at least one row of blocks.
constexpr double PartBytes = 2.0 * 1024 * 1024;

/// A nodata value whose magnitude is greater than this cannot be an angle, a fraction or an
/// irradiance.
constexpr double LargestResult = 1000.0;
/// What the bar shows when all is written and only the check is left.
constexpr double WrittenShare = 0.9;

constexpr double DefaultNodata = -9999.0;

GDALDataType TypeOf(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
    case VTK_UNSIGNED_CHAR:
      return GDT_Byte;
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
    case VTK_SHORT:
      return GDT_Int16;
    case VTK_UNSIGNED_SHORT:
      return GDT_UInt16;
    case VTK_INT:
      return GDT_Int32;
    case VTK_UNSIGNED_INT:
      return GDT_UInt32;
    case VTK_FLOAT:
      return GDT_Float32;
    default:
      return GDT_Float64; // 64-bit integers too, because few programs read such bands
  }
}

/// Finds out which of the candidate numbers occur in an array, and whether posts are missing.
struct Census
{
  std::vector<double> Candidates;
  std::vector<bool> Taken;
  bool Missing = false;

  template <typename ArrayT>
  void operator()(ArrayT* array)
  {
    for (const auto value : vtk::DataArrayValueRange(array))
    {
      const double number = static_cast<double>(value);
      if (!std::isfinite(number))
      {
        this->Missing = true;
        continue;
      }
      for (std::size_t i = 0; i < this->Candidates.size(); ++i)
      {
        if (number == this->Candidates[i])
        {
          this->Taken[i] = true;
        }
      }
    }
  }
};

/// Passes GDAL's progress to our own function, which may throw. The exception is stored here until
/// GDAL returns.
struct ProgressBridge
{
  const std::function<void(double)>& Report;
  double Begin = 0.0, End = 1.0;
  std::exception_ptr Thrown;

  static int CPL_STDCALL Call(double part, const char*, void* data)
  {
    auto* self = static_cast<ProgressBridge*>(data);
    try
    {
      self->Report(self->Begin + (self->End - self->Begin) * part);
      return TRUE;
    }
    catch (...)
    {
      self->Thrown = std::current_exception();
      return FALSE;
    }
  }
};

/// The CRS of a WKT text. If the text names an entry of the registry, that entry is used, because
/// WKT omits the codes of the parts of a compound CRS, and without them GDAL 3.10 loses the
/// vertical unit.
bool ReadCrs(const std::string& wkt, OGRSpatialReference& crs)
{
  const GdalErrors quiet;
  if (crs.SetFromUserInput(wkt.c_str()) != OGRERR_NONE)
  {
    return false;
  }
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const char* authority = crs.GetAuthorityName(nullptr);
  const char* code = crs.GetAuthorityCode(nullptr);
  OGRSpatialReference registered;
  if (authority && code &&
    registered.SetFromUserInput((std::string(authority) + ":" + code).c_str()) == OGRERR_NONE)
  {
    registered.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    crs = registered.IsSame(&crs) ? registered : crs;
  }
  return true;
}

/// Writes one file.
class GeoTiffWriter
{
public:
  GeoTiffWriter(const GeoTiffContent& content, const AtomicFile& file,
    const std::function<void(double)>& report)
    : Content(content)
    , File(file)
    , Writes(file.GetPath())
    , Report(report)
  {
    for (const BandSource& band : content.Bands)
    {
      this->Type = this->Type == GDT_Unknown ? TypeOf(band.Array)
                                             : GDALDataTypeUnion(this->Type, TypeOf(band.Array));
    }
    this->Real = this->Type == GDT_Float32 || this->Type == GDT_Float64;
    const std::size_t bands = content.Bands.size();
    this->Color = content.Picture && (bands == 3 || bands == 4);
  }

  void Write()
  {
    this->ChooseNodata();
    const bool cloud = this->Content.CloudOptimized;
    this->ProgressShare = cloud ? 0.4 : WrittenShare;
    const bool narrow = GDALGetDataTypeSizeBytes(this->Type) <= 2 || this->Type == GDT_Float32;
    this->Buffer = narrow ? GDT_Float32 : GDT_Float64;
    const std::string path =
      CheckedVsi::NameOf(cloud ? this->File.GetIntermediatePath() : this->File.GetPath());
    if (!this->WriteOnAllThreads(path))
    {
      this->Create(path);
      this->Describe();
      narrow ? this->WriteBands<float>() : this->WriteBands<double>();
      this->Close();
    }
    if (cloud)
    {
      this->Optimize(path);
    }
    CheckGeoTiff({ &this->Content, this->Buffer, this->Nodata, this->DeclareNodata }, this->File,
      [&](double part) { this->Report(WrittenShare + (1.0 - WrittenShare) * part); });
  }

private:
  /// Throws if a write failed (which GDAL is not told) or if GDAL reported a failure (which its
  /// return values need not show).
  void Check(bool good) const
  {
    if (const int error = this->Writes.GetError())
    {
      this->File.Fail(error);
    }
    if (!good || this->Errors.Any())
    {
      this->File.Fail(this->Errors.First());
    }
  }

  GDALDriver* Driver(const char* name) const
  {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(name);
    if (!driver)
    {
      this->File.Fail("this GDAL has no " + std::string(name) + " driver");
    }
    return driver;
  }

  void ChooseNodata()
  {
    if (!this->Real)
    {
      return;
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Census census;
    if (this->Content.HasNodata && std::abs(this->Content.Nodata) > LargestResult)
    {
      const bool narrow = this->Type == GDT_Float32;
      const double limit = std::numeric_limits<float>::max();
      if (!narrow)
      {
        census.Candidates.push_back(this->Content.Nodata);
      }
      else if (std::abs(this->Content.Nodata) <= limit)
      {
        census.Candidates.push_back(static_cast<double>(static_cast<float>(this->Content.Nodata)));
      }
    }
    census.Candidates.push_back(DefaultNodata);
    census.Taken.assign(census.Candidates.size(), false);
    vtkDataArray* counted = nullptr;
    for (const BandSource& band : this->Content.Bands)
    {
      if (band.Array != counted)
      {
        counted = band.Array;
        DispatchArray(counted, census);
      }
    }

    this->Nodata = nan;
    const bool asked = this->Content.HasNodata && std::isnan(this->Content.Nodata);
    for (std::size_t i = census.Candidates.size(); !asked && i-- > 0;)
    {
      this->Nodata = census.Taken[i] ? this->Nodata : census.Candidates[i];
    }
    this->DeclareNodata = census.Missing || this->Content.HasNodata;
  }

  /// The options for the layout and compression of blocks, for the file and for its separately
  /// packed parts.
  CPLStringList BlockOptions() const
  {
    const int columns = this->Content.Columns;
    const int rows = this->Content.Rows;
    CPLStringList options;
    options.SetNameValue("INTERLEAVE", this->Color ? "PIXEL" : "BAND");
    options.SetNameValue("NUM_THREADS", "1"); // errors in other threads would be lost
    if (this->Color)
    {
      options.SetNameValue("PHOTOMETRIC", "RGB");
      options.SetNameValue("ALPHA", this->Content.Bands.size() == 4 ? "YES" : "NO");
    }
    if (!this->Content.CloudOptimized)
    {
      options.SetNameValue(
        "ENDIANNESS", "LITTLE"); // TiffBlockTable needs it; overrides GDAL_TIFF_ENDIANNESS
      options.SetNameValue("COMPRESS", "DEFLATE");
      options.SetNameValue("PREDICTOR", this->Real ? "3" : "2");
    }
    if (columns > TiledFrom && rows > TiledFrom)
    {
      options.SetNameValue("TILED", "YES");
      options.SetNameValue("BLOCKXSIZE", std::to_string(TileSize).c_str());
      options.SetNameValue("BLOCKYSIZE", std::to_string(TileSize).c_str());
    }
    else
    {
      const std::int64_t bytes =
        static_cast<std::int64_t>(columns) * GDALGetDataTypeSizeBytes(this->Type);
      const std::int64_t strip = std::clamp<std::int64_t>(StripBytes / bytes, 1, rows);
      options.SetNameValue("BLOCKYSIZE", std::to_string(strip).c_str());
    }
    return options;
  }

  void Create(const std::string& path, bool withoutBlocks = false)
  {
    CPLStringList options = this->BlockOptions();
    options.SetNameValue("BIGTIFF", "IF_SAFER");
    options.SetNameValue("SPARSE_OK", withoutBlocks ? "YES" : "NO");
    const int columns = this->Content.Columns;
    const int rows = this->Content.Rows;
    this->Dataset.reset(this->Driver("GTiff")->Create(path.c_str(), columns, rows,
      static_cast<int>(this->Content.Bands.size()), this->Type, options.List()));
    this->Check(this->Dataset != nullptr);
  }

  void Describe()
  {
    const Georeference& place = this->Content.Place;
    OGRSpatialReference crs;
    if (!place.Crs.empty())
    {
      if (!ReadCrs(place.Crs, crs))
      {
        this->File.Fail("the CRS in the field data of the input is not known to PROJ");
      }
      this->Check(this->Dataset->SetSpatialRef(&crs) == CE_None);
    }
    if (place.HasGeoTransform)
    {
      std::array<double, 6> transform = place.GeoTransform;
      this->Check(this->Dataset->SetGeoTransform(transform.data()) == CE_None);
    }
    // A band without a unit would get the unit of the vertical part of the CRS.
    const std::string noUnit = crs.IsCompound() ? "1" : "";
    for (std::size_t i = 0; i < this->Content.Bands.size(); ++i)
    {
      const BandSource& source = this->Content.Bands[i];
      GDALRasterBand* band = this->Dataset->GetRasterBand(static_cast<int>(i) + 1);
      if (!this->Color || !source.Description.empty())
      {
        band->SetDescription(source.Description.c_str());
      }
      const std::string& unit = source.Unit.empty() ? noUnit : source.Unit;
      this->Check(unit.empty() || band->SetUnitType(unit.c_str()) == CE_None);
      this->Check(!this->DeclareNodata || band->SetNoDataValue(this->Nodata) == CE_None);
    }
  }

  template <typename T>
  void WriteBands()
  {
    const int columns = this->Content.Columns;
    const int rows = this->Content.Rows;
    const int bands = static_cast<int>(this->Content.Bands.size());
    int blockColumns = 1, blockRows = 1;
    this->Dataset->GetRasterBand(1)->GetBlockSize(&blockColumns, &blockRows);

    // A chunk is as many whole rows of blocks of all bands as fit, or one row of blocks of some
    // bands.
    const double blockBytes = static_cast<double>(columns) * blockRows * sizeof(T);
    const int group = static_cast<int>(std::clamp(ChunkBytes / blockBytes, 1.0, double(bands)));
    const auto blocks =
      static_cast<std::int64_t>(std::clamp(ChunkBytes / (blockBytes * group), 1.0, 1e6));
    const int chunk = static_cast<int>(std::min<std::int64_t>(blocks * blockRows, rows));
    const std::size_t bandStride = static_cast<std::size_t>(columns) * chunk;
    const GSpacing lineBytes = static_cast<GSpacing>(sizeof(T)) * columns;
    const GSpacing bandBytes = lineBytes * chunk;
    std::vector<T> buffer(bandStride * group);

    for (int row = 0; row < rows; row += chunk)
    {
      const int count = std::min(chunk, rows - row);
      for (int first = 0; first < bands; first += group)
      {
        const int groupBands = std::min(group, bands - first);
        GatherRows(
          this->Content, this->Nodata, buffer.data(), bandStride, row, count, first, groupBands);
        std::vector<int> numbers(static_cast<std::size_t>(groupBands));
        std::iota(numbers.begin(), numbers.end(), first + 1);
        const CPLErr failed =
          this->Dataset->RasterIO(GF_Write, 0, row, columns, count, buffer.data(), columns, count,
            this->Buffer, groupBands, numbers.data(), sizeof(T), lineBytes, bandBytes, nullptr);
        this->Check(failed == CE_None);
        const double done = row + count * static_cast<double>(first + groupBands) / bands;
        this->Report(this->ProgressShare * done / rows);
      }
    }
  }

  /// Writes a file in which each block belongs to one band. GDAL creates the file without blocks.
  /// Then, on each thread, GDAL packs some rows of a band as a separate file in memory, and the
  /// packed blocks are copied into the first file unchanged. Returns false, without having written
  /// anything, if this method cannot be used.
  bool WriteOnAllThreads(const std::string& path)
  {
    const int bands = static_cast<int>(this->Content.Bands.size());
    if (this->Content.CloudOptimized || this->Color)
    {
      return false;
    }
    this->Create(path, true);
    this->Describe();
    int blockColumns = 1, blockRows = 1;
    this->Dataset->GetRasterBand(1)->GetBlockSize(&blockColumns, &blockRows);
    this->Close();
    const int across = (this->Content.Columns + blockColumns - 1) / blockColumns;
    const int down = (this->Content.Rows + blockRows - 1) / blockRows;
    const std::size_t ofBand = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    TiffBlockTable table(this->File.GetPath());
    if (!table.Has(ofBand * static_cast<std::size_t>(bands)))
    {
      this->File.Fail("the table of its blocks cannot be read back");
    }

    const double rowBytes =
      static_cast<double>(this->Content.Columns) * GDALGetDataTypeSizeBytes(this->Buffer);
    const int partDown = static_cast<int>(
      std::clamp(PartBytes / (rowBytes * blockRows), 1.0, static_cast<double>(down)));
    const int parts = (down + partDown - 1) / partDown;
    const int jobs = parts * bands;
    const CPLStringList options = this->BlockOptions();
    const PackingOptions part{ &this->Content, this->Nodata, this->Type, this->Buffer,
      options.List() };
    std::vector<PackedRows> packed(static_cast<std::size_t>(jobs));
    const auto work = [&](int job)
    {
      const int row = job / bands * partDown * blockRows;
      const int count = std::min(partDown * blockRows, this->Content.Rows - row);
      packed[static_cast<std::size_t>(job)] = PackRows(part, job % bands, row, count, this->File);
    };
    const auto finish = [&](int begin, int end)
    {
      for (int job = begin; job < end; ++job)
      {
        PackedRows& result = packed[static_cast<std::size_t>(job)];
        std::size_t block = ofBand * static_cast<std::size_t>(job % bands) +
          static_cast<std::size_t>(job / bands * partDown) * static_cast<std::size_t>(across);
        for (const auto& [place, size] : result.Blocks)
        {
          table.Append(block++, result.Bytes.data() + place, size);
        }
        result = PackedRows();
      }
      this->CheckWrite(table.GetError());
      this->Report(this->ProgressShare * end / jobs);
    };
    RunInBatches(jobs, work, finish);
    if (!table.Save())
    {
      this->File.Fail("the file is too large for this type of TIFF");
    }
    this->CheckWrite(table.GetError());
    return true;
  }

  void CheckWrite(int error) const
  {
    if (error != 0)
    {
      this->File.Fail(error);
    }
  }

  void Close()
  {
    this->Dataset->FlushCache(false);
    this->Dataset.reset();
    this->Check(true);
  }

  void Optimize(const std::string& path)
  {
    const GdalDataset source(
      GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR));
    this->Check(source != nullptr);
    CPLStringList options;
    options.SetNameValue("COMPRESS", "DEFLATE");
    options.SetNameValue("PREDICTOR", "YES");
    options.SetNameValue("BIGTIFF", "IF_SAFER");
    options.SetNameValue("NUM_THREADS", "1");
    options.SetNameValue("OVERVIEW_RESAMPLING", "AVERAGE");
    const std::function<void(double)> report = [this](double part)
    {
      this->Check(true);
      this->Report(part);
    };
    ProgressBridge progress{ report, this->ProgressShare, WrittenShare, nullptr };
    const std::string target = CheckedVsi::NameOf(this->File.GetPath());
    this->Dataset.reset(this->Driver("COG")->CreateCopy(
      target.c_str(), source.get(), FALSE, options.List(), &ProgressBridge::Call, &progress));
    if (progress.Thrown)
    {
      std::rethrow_exception(progress.Thrown);
    }
    this->Check(this->Dataset != nullptr);
    this->Close();
  }

  GdalErrors Errors; // first, so that errors on closing the file are recorded
  const GeoTiffContent& Content;
  const AtomicFile& File;
  CheckedVsi Writes;
  const std::function<void(double)>& Report;
  GdalDataset Dataset;
  GDALDataType Type = GDT_Unknown;
  GDALDataType Buffer = GDT_Float32; ///< type of GDAL's input: the narrower one that holds all
  bool Real = false;
  bool Color = false;
  bool DeclareNodata = false;
  double Nodata = std::numeric_limits<double>::quiet_NaN();
  double ProgressShare = 1.0;
};

} // namespace

GeoTiffContent ContentOf(vtkImageData* image)
{
  GeoTiffContent content;
  content.Columns = image->GetDimensions()[0];
  content.Rows = image->GetDimensions()[1];
  content.HasNodata = LoadNodataValue(image, content.Nodata);
  content.Place = GeoreferenceOf(image);
  // An image without a georeference still has a distance between its posts.
  const double* spacing = image->GetSpacing();
  if (!content.Place.HasGeoTransform && (spacing[0] != 1.0 || spacing[1] != 1.0))
  {
    const double* origin = image->GetOrigin();
    const int* extent = image->GetExtent();
    content.Place.HasGeoTransform = true;
    content.Place.GeoTransform = { origin[0] + (extent[0] - 0.5) * spacing[0], spacing[0], 0.0,
      origin[1] + (extent[3] + 0.5) * spacing[1], 0.0, -spacing[1] };
  }
  return content;
}

void WriteGeoTiff(
  const GeoTiffContent& content, const AtomicFile& file, const std::function<void(double)>& report)
{
  GeoTiffWriter(content, file, report).Write();
}

} // namespace skyline
