// SPDX-License-Identifier: BSD-3-Clause
// Where the blocks (tiles or strips) of a TIFF lie: filled in from outside, because GDAL would
// compress all of them in one thread, or in threads whose errors nobody hears.
#ifndef skyline_TiffBlockTable_h
#define skyline_TiffBlockTable_h

#include "CheckedFile.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace skyline
{

/// A TIFF that was made without its blocks (GDAL: SPARSE_OK), with the tables of their places full of
/// zeros (TIFF 6.0, tags TileOffsets, TileByteCounts, StripOffsets, StripByteCounts; BigTIFF alike).
class TiffBlockTable
{
public:
  /// Reads the first directory of the little-endian TIFF at `path`.
  explicit TiffBlockTable(const std::string& path);

  /// Whether the file has tables of so many blocks.
  bool Has(std::size_t blocks) const;

  /// Writes the bytes of a block at the end of the file; the table follows with Save.
  void Append(std::size_t block, const void* bytes, std::size_t size);

  /// Writes the tables and closes the file. False if the numbers do not fit the tables.
  bool Save();

  /// The errno of the first failed write; 0: none.
  int GetError() const { return this->File.GetError(); }

private:
  struct Table
  {
    int Bytes = 0; ///< of a number
    std::int64_t Place = 0;
    std::vector<std::uint64_t> Numbers;
  };
  void ReadEntry(std::int64_t place, bool big);
  bool SaveTable(const Table& table);
  std::uint64_t ReadNumber(std::int64_t place, int bytes);

  CheckedFile File;
  Table Offsets, Counts;
};

} // namespace skyline

#endif
