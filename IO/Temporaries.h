// SPDX-License-Identifier: BSD-3-Clause
// Files on their way: each has a name and a lock, and goes when its process goes.
#ifndef skyline_Temporaries_h
#define skyline_Temporaries_h

#include "SkylineIOModule.h" // for the export macro

#include <array>
#include <string>

#include <sys/types.h>

namespace skyline
{

/// What a second temporary beside the first is called.
constexpr const char* IntermediateSuffix = ".part.tif";

/// What GDAL reads together with a raster, and what must not outlive it.
constexpr std::array<const char*, 3> SideFiles{ { ".aux.xml", ".ovr", ".msk" } };

/// One temporary file. While it lives, its descriptor holds an exclusive lock (flock), by which
/// SweepTemporaries, in whatever process, knows that it is in use. As long as one lives, each signal
/// that would end the process by default first removes all temporaries; handlers that a program has
/// of its own, and ignored signals, stay.
class Temporary
{
public:
  /// Makes an empty file in `folder`, whose name ends in `extension`, with the rights `mode` less the
  /// umask. On failure IsOpen is false and errno says why.
  Temporary(const std::string& folder, const std::string& extension, mode_t mode);
  ~Temporary();
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  bool IsOpen() const { return this->File >= 0; }
  const std::string& GetPath() const { return this->Path; }

  /// Open for reading and writing; closing it gives up the lock.
  int GetFile() const { return this->File; }

  /// Removes what lies beside it under its name, but GDAL's metadata.
  void RemoveIntermediates();

  /// Gives the side files of `target`, in the same folder, other names, so that the temporary can be
  /// renamed to it. Returns "" or, with errno, the one that cannot be renamed; all have their names
  /// then. If the process ends before the temporary is renamed, they get their names back: from the
  /// handler of the signal or, after SIGKILL, from SweepTemporaries.
  std::string PutAside(const std::string& target);

  /// The target could not be replaced: its side files get their names back. Where the system refuses
  /// that, the temporary stays, empty, so that SweepTemporaries does it later.
  void BringBack();

  /// The target has been replaced: its old side files go.
  void DropAside();

  /// Removes it, and all that lies beside it under its name.
  void Remove();

private:
  /// Signals are handled as long as one lives.
  struct HandlerUse
  {
    HandlerUse();
    ~HandlerUse();
    HandlerUse(const HandlerUse&) = delete;
    HandlerUse& operator=(const HandlerUse&) = delete;
  };

  void ForgetAside();

  HandlerUse Handled; ///< the first to come, the last to go
  std::string Path;
  std::array<std::string, SideFiles.size()> Sides, Asides; ///< the target's, and their names aside
  int File = -1;
  int Slot = -1;       ///< in the list for RemoveTemporaries
  bool Needed = false; ///< by side files that are still aside
};

/// Removes from `folder` the user's own temporaries that no process holds, as SIGKILL leaves them, and
/// gives the side files of rasters that they were to replace their names back.
/// Where the file system knows no locks, none goes.
void SweepTemporaries(const std::string& folder) noexcept;

/// TMPDIR, or /tmp without it.
std::string TemporaryFolder();

/// Removes every temporary of this process, with what GDAL puts beside it. Safe in a signal handler;
/// the program must end after it, for the writers know nothing of it.
SKYLINEIO_EXPORT void RemoveTemporaries() noexcept;

} // namespace skyline

#endif
