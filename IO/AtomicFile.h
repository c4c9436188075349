// SPDX-License-Identifier: BSD-3-Clause
// A file that appears complete or not at all.
#ifndef skyline_AtomicFile_h
#define skyline_AtomicFile_h

#include "SkylineIOModule.h" // for the export macro
#include "Temporaries.h"

#include <optional>
#include <string>
#include <vector>

namespace skyline
{

/// Reserves a temporary beside the target on construction; Commit renames it to the target's name.
/// Without Commit the temporary goes away and the target stays as it was. Temporaries that killed
/// processes left in the same folder go too.
///
/// - Behind a symbolic link, the file that it names is replaced or made, and the link stays; where
///   the system follows no link (a loop, another user's link in a sticky folder), neither do we.
/// - A target that cannot be replaced gets the bytes at the end, from a temporary in TMPDIR (default
///   /tmp): a device, a pipe, or a descriptor that the process has (/dev/stdout, /dev/fd/N), where
///   they come after what was written before, even to a file. A named pipe has PipePatience to be
///   opened by a reader.
/// - The temporary can be read by nobody who may not read the target. A new file has the rights that
///   the umask leaves, a replaced one keeps its rights and, as far as the user may give them, owner
///   and group, but is never setuid or setgid.
/// POSIX only.
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
  const std::string& GetPath() const { return this->File->GetPath(); }

  /// A second temporary beside the first, for a form in between; removed with it.
  std::string GetIntermediatePath() const;

  /// Puts the file, once it is written and closed, in the target's place, and GDAL's .aux.xml with
  /// it; such side files of what was there before are removed, for they describe another raster.
  /// Afterwards both the file and its name are on the disk.
  void Commit();

  /// What Commit replaces or removes: the target and the side files that GDAL reads with it.
  static std::vector<std::string> Endangered(const std::string& target);

  /// The failure of a write to the temporary: in the words of `reason`, unless no space is left, or
  /// those for an errno.
  [[noreturn]] void Fail(const std::string& reason) const;
  [[noreturn]] void Fail(int error) const;

private:
  void Find();
  void Reserve();
  void Replace();
  void KeepRights();
  void SyncFolder() const;
  int OpenDevice() const;
  void CopyToDevice();

  std::string Target;  ///< as the caller spelled it
  std::string Real;    ///< behind symbolic links
  int Descriptor = -1; ///< of this process, where the target names one
  bool Device = false;
  std::optional<Temporary> File;
};

/// Seconds that Commit waits for someone to read from a named pipe.
constexpr int PipePatience = 60;

} // namespace skyline

#endif
