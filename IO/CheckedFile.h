// SPDX-License-Identifier: BSD-3-Clause
// A file that remembers the first error, because the libraries that write to it may not: GDAL and
// libpng can lose the last bytes silently, and libtiff prints to stderr.
#ifndef skyline_CheckedFile_h
#define skyline_CheckedFile_h

#include "SkylineIOModule.h" // for the export macro

#include <cstddef>
#include <cstdint>
#include <string>

namespace skyline
{

/// A file with random access. After the first failed write, it ignores further writes and reports
/// success. The owner calls GetError at the end and discards the file if an error occurred.
class SKYLINEIO_EXPORT CheckedFile
{
public:
  /// Opens the file as fopen does with "r", "r+", "w" or "w+" (a "b" makes no difference). Only the
  /// user can read a new file, until AtomicFile::Commit sets its permissions.
  CheckedFile(const std::string& path, const std::string& access);
  ~CheckedFile();
  CheckedFile(const CheckedFile&) = delete;
  CheckedFile& operator=(const CheckedFile&) = delete;

  bool IsOpen() const { return this->File >= 0; }

  /// Returns the number of bytes read, which is less than `size` at the end of the file.
  std::size_t Read(void* bytes, std::size_t size, std::int64_t offset);

  void Write(const void* bytes, std::size_t size, std::int64_t offset);
  void Truncate(std::int64_t size);
  std::int64_t GetSize() const { return this->Size; }
  void Close();

  /// The errno of the first failure to open, write, truncate or close; 0 if there was none.
  int GetError() const { return this->Error; }

private:
  void Remember(bool failed);

  int File = -1;
  int Error = 0;
  std::int64_t Size = 0; ///< as if no write had failed
};

} // namespace skyline

#endif
