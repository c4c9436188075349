// SPDX-License-Identifier: BSD-3-Clause
// A file that appears complete or not at all.
#ifndef skyline_AtomicFile_h
#define skyline_AtomicFile_h

#include "SkylineIOModule.h" // for the export macro

#include <string>

namespace skyline
{

/// Reserves a temporary beside the target on construction; Commit renames it to the target's name.
/// Without Commit the temporary goes away and the target stays as it was. A target that is a device
/// or a pipe (/dev/stdout) cannot be replaced: its temporary lies in TMPDIR (default /tmp), and
/// Commit copies. The target of a symbolic link is replaced, not the link. POSIX only.
///
/// Constructor and Commit throw IoFailure with a one-line reason that names the target.
class SKYLINEIO_EXPORT AtomicFile
{
public:
  explicit AtomicFile(const std::string& target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where to write: an absolute path with the target's extension to an empty file.
  const std::string& GetPath() const { return this->Path; }

  /// A second temporary beside the first, for a form in between; removed with it.
  std::string GetIntermediatePath() const;

  /// Puts the file, once it is written and closed, in the target's place, and GDAL's .aux.xml with
  /// it; such side files of what was there before are removed, for they describe another raster.
  void Commit();

  /// The failure of a write to the temporary: in the words of `reason`, unless no space is left, or
  /// those for an errno.
  [[noreturn]] void Fail(const std::string& reason) const;
  [[noreturn]] void Fail(int error) const;

private:
  void ReserveIn(const std::string& folder);
  void Replace();
  void CopyToDevice() const;
  void Discard();

  std::string Target; ///< as the caller spelled it
  std::string Real;   ///< behind symbolic links
  std::string Path;
  bool Device = false;
  int Slot = -1; ///< in the list for RemoveTemporaries
};

/// Removes every temporary that exists now, with what GDAL puts beside it. Safe in a signal
/// handler; the program must end after it, for the writers know nothing of it.
SKYLINEIO_EXPORT void RemoveTemporaries() noexcept;

} // namespace skyline

#endif
