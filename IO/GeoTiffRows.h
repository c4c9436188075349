// SPDX-License-Identifier: BSD-3-Clause
// Rows of one band as packed TIFF blocks, made by GDAL on the calling thread.
#ifndef skyline_GeoTiffRows_h
#define skyline_GeoTiffRows_h

#include "GeoTiffFile.h"

#include <gdal.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace skyline
{

class AtomicFile;

/// How the blocks of a file are packed.
struct PackingOptions
{
  const GeoTiffContent* Content = nullptr;
  double Nodata = 0.0;                  ///< written for missing posts
  GDALDataType Stored = GDT_Float32;    ///< type of the band in the file
  GDALDataType Buffer = GDT_Float32;    ///< type of the numbers given to GDAL: Float32 or Float64
  const char* const* Options = nullptr; ///< creation options of GDAL's GTiff driver
};

/// Packed blocks in row order, each with its offset in Bytes and its size.
struct PackedRows
{
  std::vector<unsigned char> Bytes;
  std::vector<std::pair<std::size_t, std::size_t>> Blocks;
};

/// Packs rows [row, row + count), counted from the top, of the band `band`, counted from 0. `row`
/// must be the first row of a row of blocks. Throws what GDAL reports in this thread as an
/// IoFailure of `file`.
PackedRows PackRows(
  const PackingOptions& packing, int band, int row, int count, const AtomicFile& file);

} // namespace skyline

#endif
