// SPDX-License-Identifier: BSD-3-Clause
// The table of the blocks (tiles or strips) of a TIFF. It is filled in here, because GDAL would
// compress all blocks in one thread, or in threads whose errors are lost.
#ifndef skyline_TiffBlockTable_h
#define skyline_TiffBlockTable_h

#include "CheckedFile.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace skyline
{

/// A TIFF that was created without its blocks (GDAL: SPARSE_OK). The tables of their offsets and
/// sizes are full of zeros (TIFF 6.0, tags TileOffsets, TileByteCounts, StripOffsets,
/// StripByteCounts; the same in BigTIFF).
class TiffBlockTable
{
public:
  /// Reads the first directory of the little-endian TIFF at `path`.
  explicit TiffBlockTable(const std::string& path);

  /// True if the file has tables for exactly this number of blocks.
  bool Has(std::size_t blocks) const;

  /// Appends the bytes of a block to the file. Its table entry is written by Save.
  void Append(std::size_t block, const void* bytes, std::size_t size);

  /// Writes the tables and closes the file. Returns false if a number does not fit into the tables.
  bool Save();

  /// The errno of the first failed write; 0 if there was none.
  int GetError() const { return this->File.GetError(); }

private:
  struct Table
  {
    int Bytes = 0; ///< size of one number
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
