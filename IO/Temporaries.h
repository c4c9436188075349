// SPDX-License-Identifier: BSD-3-Clause
// Temporary files, each with a name and a lock, which are removed when their process ends.
#ifndef skyline_Temporaries_h
#define skyline_Temporaries_h

#include "SkylineIOModule.h" // for the export macro

#include <array>
#include <string>

#include <sys/types.h>

namespace skyline
{

/// The suffix of a second temporary beside the first.
constexpr const char* IntermediateSuffix = ".part.tif";

/// The side files that GDAL reads with a raster. They must not remain when the raster is replaced.
constexpr std::array<const char*, 3> SideFiles{ { ".aux.xml", ".ovr", ".msk" } };

/// One temporary file. While the object exists, its descriptor holds an exclusive lock (flock),
/// from which SweepTemporaries in any process sees that the file is in use. While any object
/// exists, each signal that ends the process by default first removes all temporaries. Handlers
/// that the program has installed, and ignored signals, are not changed.
class Temporary
{
public:
  /// Creates an empty file in `folder` whose name ends in `extension`, with the permissions `mode`
  /// less the umask. On failure IsOpen returns false and errno gives the reason.
  Temporary(const std::string& folder, const std::string& extension, mode_t mode);
  ~Temporary();
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  bool IsOpen() const { return this->File >= 0; }
  const std::string& GetPath() const { return this->Path; }

  /// A descriptor open for reading and writing. Closing it releases the lock.
  int GetFile() const { return this->File; }

  /// Removes the files beside the temporary that have its name, except for GDAL's metadata.
  void RemoveIntermediates();

  /// Renames the side files of `target`, which lies in the same folder, so that the temporary can
  /// be renamed to it. Returns "", or the side file that cannot be renamed, with errno set; then
  /// all have their original names. If the process ends before the temporary is renamed, the side
  /// files get their names back, either from the signal handler or, after SIGKILL, from
  /// SweepTemporaries.
  std::string PutAside(const std::string& target);

  /// To be called if the target could not be replaced: its side files get their names back. If the
  /// system refuses this, the temporary stays as an empty file, so that SweepTemporaries does it
  /// later.
  void BringBack();

  /// To be called after the target has been replaced: its old side files are removed.
  void DropAside();

  /// Removes the temporary and all files beside it that have its name.
  void Remove();

private:
  /// Signals are handled while an object of this class exists.
  struct HandlerUse
  {
    HandlerUse();
    ~HandlerUse();
    HandlerUse(const HandlerUse&) = delete;
    HandlerUse& operator=(const HandlerUse&) = delete;
  };

  void ForgetAside();

  HandlerUse Handled; ///< constructed first, destroyed last
  std::string Path;
  std::array<std::string, SideFiles.size()> Sides, Asides; ///< the target's, and their names aside
  int File = -1;
  int Slot = -1;       ///< index in the list for RemoveTemporaries
  bool Needed = false; ///< side files are still aside and need it
};

/// Removes from `folder` the user's own temporaries that no process holds, as SIGKILL leaves them,
/// and renames the side files that they had moved aside back. If the file system has no locks,
/// nothing is removed.
void SweepTemporaries(const std::string& folder) noexcept;

/// TMPDIR, or /tmp without it.
std::string TemporaryFolder();

/// Removes every temporary of this process and the files that GDAL puts beside it. A signal handler
/// may call it. The program must end afterwards, because the writers do not know that their files
/// are gone.
SKYLINEIO_EXPORT void RemoveTemporaries() noexcept;

} // namespace skyline

#endif
