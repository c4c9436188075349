// SPDX-License-Identifier: BSD-3-Clause
#include "GeoTiffCheck.h"

#include "AtomicFile.h"
#include "BandRows.h"
#include "Batches.h"
#include "GdalDataset.h"
#include "GdalErrors.h"

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace skyline
{

namespace
{

/// Number of bytes that a job compares, at least one row of blocks: enough to outweigh opening the
/// file.
constexpr double JobBytes = 4.0 * 1024 * 1024;

/// The greatest difference between the stored place and the computed one, as a part of a pixel:
/// rounding.
constexpr double PlaceSlack = 1e-6;

class GeoTiffChecker
{
public:
  GeoTiffChecker(const ExpectedGeoTiff& expected, const AtomicFile& file)
    : Expected(expected)
    , Content(*expected.Content)
    , File(file)
  {
  }

  void Check(const std::function<void(double)>& report) const
  {
    const GdalErrors errors;
    const GdalDataset dataset = this->Open(errors);
    this->CheckDescription(*dataset);
    GDALRasterBand* band = dataset->GetRasterBand(1);
    int blockColumns = 1, blockRows = 1;
    band->GetBlockSize(&blockColumns, &blockRows);
    const int bytes = GDALGetDataTypeSizeBytes(this->Expected.Buffer);
    const int bands = static_cast<int>(this->Content.Bands.size());
    const double blockBytes = static_cast<double>(this->Content.Columns) * blockRows * bytes;
    const auto blocks = static_cast<std::int64_t>(std::clamp(JobBytes / blockBytes, 1.0, 1e6));
    const int rows =
      static_cast<int>(std::min<std::int64_t>(blocks * blockRows, this->Content.Rows));
    const int parts = (this->Content.Rows + rows - 1) / rows;
    // If all bands share their blocks, one job reads all bands.
    const bool shared = bands > 1 && this->AreBandsTogether(*dataset);
    const int groups = shared ? 1 : bands;
    const auto work = [&](int job)
    {
      const int begin = job / groups * rows;
      const int count = std::min(rows, this->Content.Rows - begin);
      const int first = shared ? 0 : job % groups;
      if (this->Expected.Buffer == GDT_Float32)
      {
        this->Compare<float>(begin, count, first, shared ? bands : 1);
      }
      else
      {
        this->Compare<double>(begin, count, first, shared ? bands : 1);
      }
    };
    const int jobs = parts * groups;
    RunInBatches(jobs, work, [&](int, int end) { report(static_cast<double>(end) / jobs); });
    for (int level = 0; level < band->GetOverviewCount(); ++level)
    {
      for (int b = 1; b <= groups; ++b) // a shared block is read with the first band
      {
        this->ReadThrough(dataset->GetRasterBand(b)->GetOverview(level), errors);
      }
    }
  }

private:
  [[noreturn]] void Fail(const std::string& what) const
  {
    this->File.Fail(what + " is not what was written; the memory or the disk may be at fault");
  }

  GdalDataset Open(const GdalErrors& errors) const
  {
    // Each thread opens the file. Without this option GDAL would list the folder, which may be
    // large.
    const CPLConfigOptionSetter noListing("GDAL_DISABLE_READDIR_ON_OPEN", "TRUE", false);
    const std::array<const char*, 2> drivers{ { "GTiff", nullptr } };
    GdalDataset dataset(GDALDataset::Open(this->File.GetPath().c_str(),
      GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, drivers.data()));
    if (!dataset || errors.Any())
    {
      this->File.Fail("what was written cannot be read back: " + errors.First());
    }
    return dataset;
  }

  bool AreBandsTogether(GDALDataset& dataset) const
  {
    const char* order = dataset.GetMetadataItem("INTERLEAVE", "IMAGE_STRUCTURE");
    return order && std::string(order) == "PIXEL";
  }

  void CheckDescription(GDALDataset& dataset) const
  {
    const Georeference& place = this->Content.Place;
    const int bands = static_cast<int>(this->Content.Bands.size());
    if (dataset.GetRasterXSize() != this->Content.Columns ||
      dataset.GetRasterYSize() != this->Content.Rows || dataset.GetRasterCount() != bands)
    {
      this->Fail("the size");
    }
    std::array<double, 6> transform{};
    if (place.HasGeoTransform)
    {
      bool same = dataset.GetGeoTransform(transform.data()) == CE_None;
      for (std::size_t i = 0; i < transform.size(); ++i)
      {
        const double pixel = std::abs(place.GeoTransform[i < 3 ? 1 : 5]);
        same = same && std::abs(transform[i] - place.GeoTransform[i]) <= PlaceSlack * pixel;
      }
      if (!same)
      {
        this->Fail("the place on the map");
      }
    }
    const OGRSpatialReference* crs = dataset.GetSpatialRef();
    if (!place.Crs.empty() && (!crs || crs->IsEmpty()))
    {
      this->Fail("the CRS");
    }
    for (int i = 0; i < bands; ++i)
    {
      GDALRasterBand* band = dataset.GetRasterBand(i + 1);
      const std::string& description = this->Content.Bands[static_cast<std::size_t>(i)].Description;
      if (!description.empty() && description != band->GetDescription())
      {
        this->Fail("the description of band " + std::to_string(i + 1));
      }
      int found = 0;
      const double nodata = band->GetNoDataValue(&found);
      const bool same = nodata == this->Expected.Nodata ||
        (std::isnan(nodata) && std::isnan(this->Expected.Nodata));
      if (this->Expected.DeclareNodata && (!found || !same))
      {
        this->Fail("the nodata value of band " + std::to_string(i + 1));
      }
    }
  }

  template <typename T>
  void Compare(int row, int count, int first, int bands) const
  {
    const GdalErrors errors;
    GdalDataset dataset = this->Borrow(errors);
    const int columns = this->Content.Columns;
    const std::size_t size = static_cast<std::size_t>(columns) * static_cast<std::size_t>(count);
    std::vector<T> wanted(size), stored(size);
    for (int band = first; band < first + bands; ++band)
    {
      GatherRows(this->Content, this->Expected.Nodata, wanted.data(), size, row, count, band, 1);
      const CPLErr failed = dataset->GetRasterBand(band + 1)->RasterIO(GF_Read, 0, row, columns,
        count, stored.data(), columns, count, this->Expected.Buffer, 0, 0, nullptr);
      if (failed != CE_None || errors.Any())
      {
        this->File.Fail("what was written cannot be read back: " + errors.First());
      }
      const bool same = std::equal(wanted.begin(), wanted.end(), stored.begin(),
        [](T a, T b) { return a == b || (std::isnan(a) && std::isnan(b)); });
      if (!same)
      {
        this->Fail("band " + std::to_string(band + 1));
      }
    }
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Idle.push_back(std::move(dataset));
  }

  /// An open file for one job. Open files are reused, because opening a file of thousands of bands
  /// takes longer than reading one band.
  GdalDataset Borrow(const GdalErrors& errors) const
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->Idle.empty())
      {
        GdalDataset dataset = std::move(this->Idle.back());
        this->Idle.pop_back();
        return dataset;
      }
    }
    return this->Open(errors);
  }

  /// Checks that an overview has all its blocks and that each block can be unpacked.
  void ReadThrough(GDALRasterBand* overview, const GdalErrors& errors) const
  {
    int blockColumns = 1, blockRows = 1;
    overview->GetBlockSize(&blockColumns, &blockRows);
    std::vector<unsigned char> block(static_cast<std::size_t>(blockColumns) *
      static_cast<std::size_t>(blockRows) *
      static_cast<std::size_t>(GDALGetDataTypeSizeBytes(overview->GetRasterDataType())));
    for (int y = 0; y * blockRows < overview->GetYSize(); ++y)
    {
      for (int x = 0; x * blockColumns < overview->GetXSize(); ++x)
      {
        const std::string name = "BLOCK_OFFSET_" + std::to_string(x) + "_" + std::to_string(y);
        if (overview->ReadBlock(x, y, block.data()) != CE_None || errors.Any() ||
          !overview->GetMetadataItem(name.c_str(), "TIFF"))
        {
          this->Fail("an overview");
        }
      }
    }
  }

  const ExpectedGeoTiff& Expected;
  const GeoTiffContent& Content;
  const AtomicFile& File;
  mutable std::mutex Mutex;
  mutable std::vector<GdalDataset> Idle; ///< open files that no job uses now
};

} // namespace

void CheckGeoTiff(const ExpectedGeoTiff& expected, const AtomicFile& file,
  const std::function<void(double)>& report)
{
  GeoTiffChecker(expected, file).Check(report);
}

} // namespace skyline
