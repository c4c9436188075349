// SPDX-License-Identifier: BSD-3-Clause
// Files on their way: each has a name and a lock, and goes when its process goes.
#ifndef skyline_Temporaries_h
#define skyline_Temporaries_h

#include "SkylineIOModule.h" // for the export macro

#include <string>

#include <sys/types.h>

namespace skyline
{

/// What a second temporary beside the first is called.
constexpr const char* IntermediateSuffix = ".part.tif";

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

  /// Removes it, and all that lies beside it under its name.
  void Remove();

private:
  std::string Path;
  int File = -1;
  int Slot = -1; ///< in the list for RemoveTemporaries
};

/// Removes from `folder` the user's own temporaries that no process holds, as SIGKILL leaves them.
/// Where the file system knows no locks, none goes.
void SweepTemporaries(const std::string& folder) noexcept;

/// Removes every temporary of this process, with what GDAL puts beside it. Safe in a signal handler;
/// the program must end after it, for the writers know nothing of it.
SKYLINEIO_EXPORT void RemoveTemporaries() noexcept;

} // namespace skyline

#endif
