// SPDX-License-Identifier: BSD-3-Clause
#include "AtomicFile.h"

#include "IoFailure.h"

#include "vtkErrorCode.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <random>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace skyline
{

namespace
{

/// What may lie beside a temporary: GDAL's metadata, our intermediate, the COG driver's overviews.
constexpr const char* IntermediateSuffix = ".part.tif";
constexpr std::array<const char*, 6> Suffixes{ { "", ".aux.xml", IntermediateSuffix,
  ".part.tif.aux.xml", ".ovr.tmp", ".msk.ovr.tmp" } };
constexpr std::size_t LongestSuffix = 32;

/// What GDAL reads together with a raster, and what must not outlive it.
constexpr std::array<const char*, 3> SideFiles{ { ".aux.xml", ".ovr", ".msk" } };

/// A file system with less space than this counts as full: writers ask for about this much.
constexpr double NoSpace = 64.0 * 1024;

/// The temporaries of the process, in memory that a signal handler may read.
struct Entry
{
  enum State
  {
    Free,
    Changing,
    Used
  };
  std::atomic<int> State{ Free };
  char Path[PATH_MAX] = {};
};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler reads it");
std::array<Entry, 16> Entries;

/// Enters a path; -1 when the list is full or the path too long, which only a signal will miss.
int Enter(const std::string& path)
{
  if (path.size() + LongestSuffix >= PATH_MAX)
  {
    return -1;
  }
  for (std::size_t i = 0; i < Entries.size(); ++i)
  {
    int expected = Entry::Free;
    if (Entries[i].State.compare_exchange_strong(expected, Entry::Changing))
    {
      std::memcpy(Entries[i].Path, path.c_str(), path.size() + 1);
      Entries[i].State = Entry::Used;
      return static_cast<int>(i);
    }
  }
  return -1;
}

/// The path without links, dots and double slashes; the path itself where there is none.
std::string RealPath(const std::string& path)
{
  std::string real = path;
  if (char* resolved = ::realpath(path.c_str(), nullptr))
  {
    real = resolved;
    std::free(resolved);
  }
  return real;
}

std::string FolderOf(const std::string& path)
{
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos)
  {
    return ".";
  }
  return slash == 0 ? "/" : path.substr(0, slash);
}

/// The extension with its dot, if it looks like one.
std::string ExtensionOf(const std::string& path)
{
  const std::size_t dot = path.find_last_of("./");
  const bool usable =
    dot != std::string::npos && path[dot] == '.' && path.size() - dot <= LongestSuffix;
  return usable ? path.substr(dot) : "";
}

unsigned long CodeFor(int error)
{
  const bool full = error == ENOSPC || error == EDQUOT || error == EFBIG;
  return full ? vtkErrorCode::OutOfDiskSpaceError : vtkErrorCode::CannotOpenFileError;
}

const char* CureFor(int error)
{
  switch (error)
  {
    case ENOENT:
    case ENOTDIR:
      return "; make its folder first";
    case EACCES:
    case EPERM:
    case EROFS:
      return "; choose a place where you may write";
    case EISDIR:
      return "; add a file name";
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "; free some space or choose another place";
    default:
      return "; choose another place";
  }
}

} // namespace

AtomicFile::AtomicFile(const std::string& target)
  : Target(target)
  , Real(RealPath(target))
{
  struct stat status;
  std::string folder = FolderOf(this->Real);
  if (::stat(this->Real.c_str(), &status) == 0)
  {
    if (S_ISDIR(status.st_mode))
    {
      this->Fail(EISDIR);
    }
    if (::access(this->Real.c_str(), W_OK) != 0)
    {
      this->Fail(errno);
    }
    this->Device = !S_ISREG(status.st_mode);
    if (this->Device)
    {
      const char* temporary = std::getenv("TMPDIR");
      folder = temporary && *temporary ? temporary : "/tmp";
    }
  }
  this->ReserveIn(RealPath(folder));
}

AtomicFile::~AtomicFile()
{
  this->Discard();
}

void AtomicFile::ReserveIn(const std::string& folder)
{
  std::random_device random;
  for (int attempt = 0; attempt < 100; ++attempt)
  {
    this->Path = folder + "/.skyline-" + std::to_string(::getpid()) + "-" +
      std::to_string(random()) + ".part" + ExtensionOf(this->Target);
    // In the list before it exists, so that no signal finds it unlisted.
    this->Slot = Enter(this->Path);
    const int file = ::open(this->Path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0)
    {
      ::close(file);
      return;
    }
    const int error = errno;
    const bool taken = error == EEXIST;
    if (this->Slot >= 0)
    {
      Entries[static_cast<std::size_t>(this->Slot)].State = Entry::Free;
      this->Slot = -1;
    }
    this->Path.clear();
    if (!taken)
    {
      this->Fail(error);
    }
  }
  this->Fail(EEXIST);
}

std::string AtomicFile::GetIntermediatePath() const
{
  return this->Path + IntermediateSuffix;
}

void AtomicFile::Commit()
{
  if (this->Device)
  {
    this->CopyToDevice();
  }
  else
  {
    this->Replace();
  }
  this->Discard();
}

void AtomicFile::Replace()
{
  // Some file systems notice only here that they are full.
  const int file = ::open(this->Path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = file >= 0 && (::fsync(file) == 0 || errno == EINVAL);
  const int error = errno;
  if (file >= 0)
  {
    ::close(file);
  }
  if (!synced)
  {
    this->Fail(error);
  }

  struct stat status;
  if (::stat(this->Real.c_str(), &status) == 0)
  {
    (void)::chmod(this->Path.c_str(), status.st_mode & 07777);
  }
  if (::rename(this->Path.c_str(), this->Real.c_str()) != 0)
  {
    this->Fail(errno);
  }
  for (const char* suffix : SideFiles)
  {
    ::unlink((this->Real + suffix).c_str());
  }
  (void)::rename((this->Path + ".aux.xml").c_str(), (this->Real + ".aux.xml").c_str());
}

void AtomicFile::CopyToDevice() const
{
  const int from = ::open(this->Path.c_str(), O_RDONLY | O_CLOEXEC);
  const int to = ::open(this->Real.c_str(), O_WRONLY | O_CLOEXEC);
  int error = from < 0 || to < 0 ? errno : 0;
  std::array<char, 65536> buffer;
  while (error == 0)
  {
    const ssize_t count = ::read(from, buffer.data(), buffer.size());
    if (count <= 0)
    {
      error = count < 0 ? errno : 0;
      break;
    }
    for (ssize_t done = 0; done < count && error == 0;)
    {
      const ssize_t written =
        ::write(to, buffer.data() + done, static_cast<std::size_t>(count - done));
      if (written >= 0)
      {
        done += written;
      }
      else if (errno != EINTR)
      {
        error = errno;
      }
    }
  }
  if (from >= 0)
  {
    ::close(from);
  }
  if (to >= 0 && ::close(to) != 0 && error == 0)
  {
    error = errno;
  }
  if (error != 0)
  {
    this->Fail(error);
  }
}

void AtomicFile::Discard()
{
  if (!this->Path.empty())
  {
    for (const char* suffix : Suffixes)
    {
      ::unlink((this->Path + suffix).c_str());
    }
  }
  if (this->Slot >= 0)
  {
    Entries[static_cast<std::size_t>(this->Slot)].State = Entry::Free;
  }
  this->Path.clear();
  this->Slot = -1;
}

void AtomicFile::Fail(const std::string& reason) const
{
  struct statvfs space;
  if (::statvfs(FolderOf(this->Path).c_str(), &space) == 0 &&
    static_cast<double>(space.f_bavail) * static_cast<double>(space.f_frsize) < NoSpace)
  {
    this->Fail(ENOSPC);
  }
  throw IoFailure(vtkErrorCode::UnknownError,
    "cannot write '" + this->Target + "': " + FirstLine(reason) + "; choose another place");
}

void AtomicFile::Fail(int error) const
{
  throw IoFailure(CodeFor(error),
    "cannot write '" + this->Target + "': " + std::strerror(error) + CureFor(error));
}

void RemoveTemporaries() noexcept
{
  for (Entry& entry : Entries)
  {
    if (entry.State != Entry::Used)
    {
      continue;
    }
    char path[PATH_MAX];
    const std::size_t length = std::strlen(entry.Path);
    std::memcpy(path, entry.Path, length);
    for (const char* suffix : Suffixes)
    {
      std::memcpy(path + length, suffix, std::strlen(suffix) + 1);
      ::unlink(path);
    }
  }
}

} // namespace skyline
