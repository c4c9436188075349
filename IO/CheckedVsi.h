// SPDX-License-Identifier: BSD-3-Clause
// CheckedFile for GDAL: names under which GDAL writes files and every failure is known.
#ifndef skyline_CheckedVsi_h
#define skyline_CheckedVsi_h

#include <atomic>
#include <memory>
#include <string>

namespace skyline
{

/// Hears of failed writes to a file and to those whose name begins with its name, as long as they
/// go by GetName and the like.
class CheckedVsi
{
public:
  /// `path` is absolute.
  explicit CheckedVsi(const std::string& path);
  ~CheckedVsi();
  CheckedVsi(const CheckedVsi&) = delete;
  CheckedVsi& operator=(const CheckedVsi&) = delete;

  /// What to call a path in GDAL.
  static std::string NameOf(const std::string& path);

  /// The errno of the first failure; 0: none.
  int GetError() const { return *this->Error; }

private:
  std::string Path;
  std::shared_ptr<std::atomic<int>> Error;
};

} // namespace skyline

#endif
