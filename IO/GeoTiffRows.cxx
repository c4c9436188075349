// SPDX-License-Identifier: BSD-3-Clause
#include "GeoTiffRows.h"

#include "AtomicFile.h"
#include "BandRows.h"
#include "GdalDataset.h"
#include "GdalErrors.h"

#include <cpl_string.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

namespace skyline
{

namespace
{

/// The name of a file in memory. The destructor removes the file.
struct MemoryFile
{
  MemoryFile()
    : Name("/vsimem/skyline/" + std::to_string(reinterpret_cast<std::uintptr_t>(this)) + ".tif")
  {
  }
  ~MemoryFile() { VSIUnlink(this->Name.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string Name;
};

/// Packs rows into one file in memory.
class Packer
{
public:
  Packer(const PackingOptions& packing, const AtomicFile& file)
    : Packing(packing)
    , File(file)
  {
  }

  template <typename T>
  PackedRows Pack(int band, int row, int count)
  {
    std::vector<T> rows(
      static_cast<std::size_t>(this->Packing.Content->Columns) * static_cast<std::size_t>(count));
    GatherRows(
      *this->Packing.Content, this->Packing.Nodata, rows.data(), rows.size(), row, count, band, 1);
    this->Write(rows.data(), count);
    PackedRows packed;
    this->FindBlocks(packed, count);
    this->TakeBytes(packed);
    return packed;
  }

private:
  void Check(bool good) const
  {
    if (!good || this->Errors.Any())
    {
      this->File.Fail(this->Errors.First("GDAL could not pack some rows"));
    }
  }

  void Write(void* rows, int count) const
  {
    const int columns = this->Packing.Content->Columns;
    CPLStringList options(CSLDuplicate(const_cast<char**>(this->Packing.Options)));
    if (!options.FetchBool("TILED", false))
    {
      const int strip =
        static_cast<int>(std::strtol(options.FetchNameValueDef("BLOCKYSIZE", "1"), nullptr, 10));
      options.SetNameValue("BLOCKYSIZE", std::to_string(std::min(strip, count)).c_str());
    }
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    this->Check(driver != nullptr);
    GdalDataset dataset(driver->Create(
      this->Memory.Name.c_str(), columns, count, 1, this->Packing.Stored, options.List()));
    this->Check(dataset != nullptr);
    this->Check(dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, columns, count, rows, columns,
                  count, this->Packing.Buffer, 0, 0, nullptr) == CE_None);
    dataset->FlushCache(false);
    dataset.reset();
    this->Check(true);
  }

  std::size_t Number(GDALRasterBand* band, const std::string& name) const
  {
    const char* text = band->GetMetadataItem(name.c_str(), "TIFF");
    this->Check(text != nullptr);
    return static_cast<std::size_t>(std::strtoull(text, nullptr, 10));
  }

  void FindBlocks(PackedRows& packed, int count) const
  {
    const GdalDataset dataset(
      GDALDataset::Open(this->Memory.Name.c_str(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR));
    this->Check(dataset != nullptr);
    GDALRasterBand* band = dataset->GetRasterBand(1);
    int blockColumns = 1, blockRows = 1;
    band->GetBlockSize(&blockColumns, &blockRows);
    for (int y = 0; y * blockRows < count; ++y)
    {
      for (int x = 0; x * blockColumns < this->Packing.Content->Columns; ++x)
      {
        const std::string block = std::to_string(x) + "_" + std::to_string(y);
        packed.Blocks.emplace_back(
          this->Number(band, "BLOCK_OFFSET_" + block), this->Number(band, "BLOCK_SIZE_" + block));
      }
    }
  }

  void TakeBytes(PackedRows& packed) const
  {
    vsi_l_offset length = 0;
    const GByte* bytes = VSIGetMemFileBuffer(this->Memory.Name.c_str(), &length, FALSE);
    this->Check(bytes != nullptr);
    packed.Bytes.assign(bytes, bytes + length);
    for (const auto& [place, size] : packed.Blocks)
    {
      this->Check(size > 0 && place <= length && size <= length - place);
    }
  }

  const GdalErrors Errors; // first, so that errors on removing the file are recorded
  const PackingOptions& Packing;
  const AtomicFile& File;
  const MemoryFile Memory;
};

} // namespace

PackedRows PackRows(
  const PackingOptions& packing, int band, int row, int count, const AtomicFile& file)
{
  Packer packer(packing, file);
  return packing.Buffer == GDT_Float32 ? packer.Pack<float>(band, row, count)
                                       : packer.Pack<double>(band, row, count);
}

} // namespace skyline
