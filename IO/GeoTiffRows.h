// SPDX-License-Identifier: BSD-3-Clause
// Rows of one band as packed blocks of a TIFF, made by GDAL in whatever thread asks.
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
struct PackingWay
{
  const GeoTiffContent* Content = nullptr;
  double Nodata = 0.0;                  ///< in place of missing posts
  GDALDataType Stored = GDT_Float32;    ///< the band's type
  GDALDataType Buffer = GDT_Float32;    ///< numbers as GDAL gets them: Float32 or Float64
  const char* const* Options = nullptr; ///< creation options of GDAL's GTiff driver
};

/// The blocks, from the top and from the left: a place in Bytes and a size.
struct PackedRows
{
  std::vector<unsigned char> Bytes;
  std::vector<std::pair<std::size_t, std::size_t>> Blocks;
};

/// Packs rows [row, row + count) from the top of the band `band`, counted from 0; `row` begins a row of
/// blocks. What GDAL reports in this thread is thrown as an IoFailure of `file`.
PackedRows PackRows(const PackingWay& way, int band, int row, int count, const AtomicFile& file);

} // namespace skyline

#endif
