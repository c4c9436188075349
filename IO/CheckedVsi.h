// SPDX-License-Identifier: BSD-3-Clause
// CheckedFile for GDAL: GDAL writes files under special names, and every failure is recorded.
#ifndef skyline_CheckedVsi_h
#define skyline_CheckedVsi_h

#include <atomic>
#include <memory>
#include <string>

namespace skyline
{

/// Records failed writes to a file, and to files whose names begin with its name, if GDAL opens
/// them under the names that NameOf returns.
class CheckedVsi
{
public:
  /// `path` is an absolute path.
  explicit CheckedVsi(const std::string& path);
  ~CheckedVsi();
  CheckedVsi(const CheckedVsi&) = delete;
  CheckedVsi& operator=(const CheckedVsi&) = delete;

  /// The name under which GDAL must open the file `path`.
  static std::string NameOf(const std::string& path);

  /// The errno of the first failure; 0 if there was none.
  int GetError() const { return *this->Error; }

private:
  std::string Path;
  std::shared_ptr<std::atomic<int>> Error;
};

} // namespace skyline

#endif
