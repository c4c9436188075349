// SPDX-License-Identifier: BSD-3-Clause
// A file that appears either complete or not at all.
#ifndef skyline_AtomicFile_h
#define skyline_AtomicFile_h

#include "SkylineIOModule.h" // for the export macro
#include "Temporaries.h"

#include <optional>
#include <string>
#include <vector>

namespace skyline
{

/// Creates a temporary file beside the target on construction. Commit renames it to the target's
/// name. Without Commit, the temporary is removed and the target stays as it was. Temporaries that
/// killed processes left in the same folder are removed too.
///
/// - If the target is a symbolic link, the file that it names is replaced or created, and the link
///   stays. A link that the system refuses to follow (a loop, another user's link in a sticky
///   folder) is an error.
/// - A target that cannot be replaced receives the bytes at the end, from a temporary in TMPDIR
///   (default /tmp). Such targets are devices, pipes and open descriptors of the process
///   (/dev/stdout, /dev/fd/N). The bytes follow what was written to the descriptor before, even if
///   it is a file. A reader must open a named pipe within PipePatience.
/// - Nobody can read the temporary who may not read the target. A new file has the permissions that
///   the umask leaves. A replaced file keeps its permissions and, as far as the user may set them,
///   its owner and group, but it is never setuid or setgid.
///
/// POSIX only. The constructor and Commit throw IoFailure with a one-line reason that names the
/// target.
class SKYLINEIO_EXPORT AtomicFile
{
public:
  explicit AtomicFile(const std::string& target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// The absolute path of the empty temporary file to write to. It has the target's extension.
  const std::string& GetPath() const { return this->File->GetPath(); }

  /// The path of a second temporary beside the first, for an intermediate form. It is removed with
  /// the first.
  std::string GetIntermediatePath() const;

  /// Puts the written and closed file in the place of the target, together with its .aux.xml file
  /// of GDAL. Side files of the replaced raster are removed, because they describe that raster.
  /// When Commit returns, the file and its name are on the disk.
  void Commit();

  /// The files that Commit replaces or removes: the target and the side files that GDAL reads with
  /// it.
  static std::vector<std::string> FilesToBeReplaced(const std::string& target);

  /// Throws the IoFailure for a failed write to the temporary. The message contains `reason`
  /// (unless the disk is full) or the system's text for an errno.
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

  std::string Target;  ///< as given by the caller
  std::string Real;    ///< with symbolic links resolved
  int Descriptor = -1; ///< the descriptor of this process that the target names, or -1
  bool Device = false;
  std::optional<Temporary> File;
};

/// How long Commit waits for a reader of a named pipe, in seconds.
constexpr int PipePatience = 60;

} // namespace skyline

#endif
