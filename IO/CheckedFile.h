// SPDX-License-Identifier: BSD-3-Clause
// A file that remembers what went wrong, because the libraries that write to it may not: GDAL and
// libpng can lose the last bytes without a word, and libtiff prints where nobody asked.
#ifndef skyline_CheckedFile_h
#define skyline_CheckedFile_h

#include "SkylineIOModule.h" // for the export macro

#include <cstddef>
#include <cstdint>
#include <string>

namespace skyline
{

/// Random access. From the first failed write on, the file swallows what it is given, as if all
/// went well; whoever owns it asks GetError and throws the result away.
class SKYLINEIO_EXPORT CheckedFile
{
public:
  /// What fopen would do with "r", "r+", "w" or "w+" (b does not matter); a new file is the user's own
  /// to read, until AtomicFile::Commit says who else may.
  CheckedFile(const std::string& path, const std::string& access);
  ~CheckedFile();
  CheckedFile(const CheckedFile&) = delete;
  CheckedFile& operator=(const CheckedFile&) = delete;

  bool IsOpen() const { return this->File >= 0; }

  /// Bytes read: fewer than `size` at the end of the file.
  std::size_t Read(void* bytes, std::size_t size, std::int64_t offset);

  void Write(const void* bytes, std::size_t size, std::int64_t offset);
  void Truncate(std::int64_t size);
  std::int64_t GetSize() const { return this->Size; }
  void Close();

  /// The errno of the first failure to open, write, shorten or close; 0: none.
  int GetError() const { return this->Error; }

private:
  void Remember(bool failed);

  int File = -1;
  int Error = 0;
  std::int64_t Size = 0; ///< as if all went well
};

} // namespace skyline

#endif
