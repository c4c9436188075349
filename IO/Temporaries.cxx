// SPDX-License-Identifier: BSD-3-Clause
#include "Temporaries.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <mutex>
#include <random>
#include <utility>
#include <vector>

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace skyline
{

namespace
{

/// Temporaries are named ".skyline-held-PROCESS-NUMBER.part.EXTENSION" and are locked while they
/// are in use.
constexpr const char* NameBegin = ".skyline-held-";
constexpr const char* NameMiddle = ".part";

/// Files that may lie beside a temporary: GDAL's metadata, our intermediate file, overviews of the
/// COG driver. The temporary itself (empty suffix) is removed last: a side file without its
/// temporary has no owner.
constexpr const char* MetadataSuffix = ".aux.xml";
constexpr std::array<const char*, 6> Suffixes{ { MetadataSuffix, IntermediateSuffix,
  ".part.tif.aux.xml", ".ovr.tmp", ".msk.ovr.tmp", "" } };
constexpr std::size_t LongestSuffix = 32;

/// "TEMPORARY.of.NAME" is the side file NAME of the raster that TEMPORARY is about to replace.
/// Whoever removes the temporary renames the side file back to NAME. If the temporary no longer
/// exists for another reason, it has replaced the raster, and the side file describes a raster that
/// no longer exists.
constexpr const char* AsideMiddle = ".of.";

/// A file without its temporary has no owner after this many seconds. Before that, its process may
/// be about to rename it.
constexpr double AloneSeconds = 60.0;

/// A temporary of this process, in memory that a signal handler may read.
struct Entry
{
  enum State
  {
    Free,
    Changing,
    Used
  };
  std::atomic<int> State{ Free };
  pid_t Owner = 0; ///< after a fork, the child has its parent's entries too
  char Path[PATH_MAX] = {};
  std::atomic<bool> Aside{ false };
  char Target[PATH_MAX] = {}; ///< the target whose side files are aside
};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler reads it");
std::array<Entry, 16> Entries;

/// Adds a path to the list. Returns -1 if the list is full or the path too long; the file is then
/// not removed on a signal.
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
      Entries[i].Aside = false;
      Entries[i].Owner = ::getpid();
      Entries[i].State = Entry::Used;
      return static_cast<int>(i);
    }
  }
  return -1;
}

/// The signals that end a process by default.
constexpr std::array<int, 20> Endings{ { SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGALRM,
  SIGXCPU, SIGXFSZ, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGUSR1, SIGUSR2, SIGVTALRM, SIGPROF,
  SIGIO, SIGSYS, SIGTRAP } };

extern "C" void TidyUpAndEnd(int number)
{
  const int error = errno;
  RemoveTemporaries();
  std::signal(number, SIG_DFL);
  (void)std::raise(number); // takes effect when the handler returns
  errno = error;
}

/// The handlers are installed while a temporary exists.
struct Handlers
{
  std::mutex Mutex;
  int Users = 0;

  static Handlers& Get()
  {
    static Handlers handlers;
    return handlers;
  }

  void Add()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Users++ == 0)
    {
      Replace(SIG_DFL, TidyUpAndEnd);
    }
  }
  void Drop()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (--this->Users == 0)
    {
      Replace(TidyUpAndEnd, SIG_DFL);
    }
  }

  using Handler = void (*)(int);
  static void Replace(Handler from, Handler to)
  {
    for (const int number : Endings)
    {
      struct sigaction now = {};
      if (::sigaction(number, nullptr, &now) == 0 && !(now.sa_flags & SA_SIGINFO) &&
        now.sa_handler == from)
      {
        now.sa_handler = to;
        now.sa_flags = 0;
        ::sigaction(number, &now, nullptr);
      }
    }
  }
};

/// A descriptor that is closed by the destructor.
struct Opened
{
  explicit Opened(int file)
    : File(file)
  {
  }
  ~Opened()
  {
    if (this->File >= 0)
    {
      ::close(this->File);
    }
  }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  int File;
};

/// Removes a temporary whose process has ended. Calls `before` first, while no other process can
/// remove it. Returns false if there is no such temporary.
template <typename Before>
bool RemoveDead(int folder, const char* name, const Before& before)
{
  struct stat status;
  if (::fstatat(folder, name, &status, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(status.st_mode) ||
    status.st_uid != ::geteuid())
  {
    return false;
  }
  const Opened file(::openat(folder, name, O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  // While we hold the lock, a process that just created the file cannot lock it: see Temporary.
  if (file.File < 0 || ::flock(file.File, LOCK_EX | LOCK_NB) != 0)
  {
    return false;
  }
  before();
  return ::unlinkat(folder, name, 0) == 0;
}

/// The name of the temporary that a file lies beside, or the name itself if it is a temporary.
std::string OwnerOf(const std::string& name)
{
  for (const char* suffix : Suffixes)
  {
    const std::size_t length = std::strlen(suffix);
    if (length > 0 && name.size() > length &&
      name.compare(name.size() - length, length, suffix) == 0)
    {
      std::string owner = name.substr(0, name.size() - length);
      if (owner.find(NameMiddle) != std::string::npos)
      {
        return owner;
      }
    }
  }
  return name;
}

/// Renames a side file back to its original name, unless that name is in use again.
void NameAgain(int folder, const std::string& aside, const std::string& name)
{
  (void)::linkat(folder, aside.c_str(), folder, name.c_str(), 0);
  ::unlinkat(folder, aside.c_str(), 0);
}

bool IsGone(int folder, const std::string& name)
{
  struct stat status;
  return ::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0 && errno == ENOENT;
}

bool IsOurs(int folder, const std::string& name)
{
  struct stat status;
  return ::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
    status.st_uid == ::geteuid();
}

/// Handles a side file that its process could not remove or rename.
void SweepAside(int folder, const std::string& name)
{
  const std::string owner = name.substr(0, name.find(AsideMiddle));
  if (IsGone(folder, owner) && IsOurs(folder, name))
  {
    ::unlinkat(folder, name.c_str(), 0);
  }
}

/// Handles a temporary, or a file beside it. `asides` are the renamed side files in the folder.
void SweepName(int folder, const std::string& name, const std::vector<std::string>& asides)
{
  const std::string owner = OwnerOf(name);
  struct stat status;
  const bool alone = owner != name && IsGone(folder, owner) &&
    ::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
    std::difftime(std::time(nullptr), status.st_ctime) > AloneSeconds;
  const auto nameAgain = [&]
  {
    for (const std::string& aside : asides)
    {
      const std::size_t middle = aside.find(AsideMiddle);
      if (aside.compare(0, middle, owner) == 0 && IsOurs(folder, aside))
      {
        NameAgain(folder, aside, aside.substr(middle + std::strlen(AsideMiddle)));
      }
    }
  };
  if (!alone && !RemoveDead(folder, owner.c_str(), nameAgain))
  {
    return;
  }
  for (const char* suffix : Suffixes)
  {
    if (*suffix && IsOurs(folder, owner + suffix))
    {
      ::unlinkat(folder, (owner + suffix).c_str(), 0);
    }
  }
}

/// Bytes of a path and of the name after AsideMiddle.
constexpr std::size_t LongestAside = PATH_MAX + NAME_MAX + 1;

/// Appends `text` to the string that ends at `end`. Returns the new end.
char* Append(char* end, const char* text)
{
  const std::size_t length = std::strlen(text);
  std::memcpy(end, text, length + 1);
  return end + length;
}

/// Writes the name of a side file while it is aside into a buffer of LongestAside bytes. Allocates
/// no memory, so that a signal handler may call it.
void NameAside(char* aside, const char* path, const char* target, const char* suffix)
{
  const char* slash = std::strrchr(target, '/');
  aside = Append(Append(aside, path), AsideMiddle);
  Append(Append(aside, slash ? slash + 1 : target), suffix);
}

} // namespace

Temporary::HandlerUse::HandlerUse()
{
  Handlers::Get().Add();
}

Temporary::HandlerUse::~HandlerUse()
{
  Handlers::Get().Drop();
}

Temporary::Temporary(const std::string& folder, const std::string& extension, mode_t mode)
{
  std::random_device random;
  int error = EEXIST;
  for (int attempt = 0; attempt < 100 && error == EEXIST; ++attempt)
  {
    std::string path = folder;
    path.append("/").append(NameBegin).append(std::to_string(::getpid())).append("-");
    path.append(std::to_string(random())).append(NameMiddle).append(extension);
    this->Path = std::move(path);
    // The path is listed before the file exists, so that a signal always finds it in the list.
    this->Slot = Enter(this->Path);
    this->File =
      ::open(this->Path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, mode);
    error = errno;
    if (this->File >= 0)
    {
      // A sweeping process may have removed the file before it was locked.
      const bool locked = ::flock(this->File, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
      struct stat status;
      if (locked && ::fstat(this->File, &status) == 0 && status.st_nlink > 0)
      {
        return;
      }
      error = EEXIST;
    }
    this->Remove();
  }
  errno = error;
}

Temporary::~Temporary()
{
  this->Remove();
}

void Temporary::RemoveIntermediates()
{
  for (const char* suffix : Suffixes)
  {
    if (*suffix && suffix != MetadataSuffix)
    {
      ::unlink((this->Path + suffix).c_str());
    }
  }
}

std::string Temporary::PutAside(const std::string& target)
{
  // All names are made first: once a side file is aside, nothing may fail for lack of memory.
  const std::string aside = this->Path + AsideMiddle + target.substr(target.rfind('/') + 1);
  for (std::size_t i = 0; i < SideFiles.size(); ++i)
  {
    this->Sides[i] = target + SideFiles[i];
    this->Asides[i] = aside + SideFiles[i];
  }
  if (this->Slot >= 0 && target.size() + LongestSuffix < PATH_MAX &&
    this->Asides[0].size() + LongestSuffix < LongestAside)
  {
    Entry& entry = Entries[static_cast<std::size_t>(this->Slot)];
    std::memcpy(entry.Target, target.c_str(), target.size() + 1);
    entry.Aside = true;
  }
  for (std::size_t i = 0; i < SideFiles.size(); ++i)
  {
    const std::string& side = this->Sides[i];
    const bool possible = side.size() - (side.rfind('/') + 1) <= NAME_MAX;
    if (possible && ::rename(side.c_str(), this->Asides[i].c_str()) != 0 && errno != ENOENT)
    {
      const int error = errno;
      this->BringBack();
      errno = error;
      return side;
    }
  }
  return "";
}

void Temporary::BringBack()
{
  for (std::size_t i = 0; i < SideFiles.size(); ++i)
  {
    const bool back = ::rename(this->Asides[i].c_str(), this->Sides[i].c_str()) == 0;
    this->Needed = this->Needed || (!back && ::access(this->Asides[i].c_str(), F_OK) == 0);
  }
  this->ForgetAside();
}

void Temporary::DropAside()
{
  for (const std::string& aside : this->Asides)
  {
    ::unlink(aside.c_str());
  }
  this->ForgetAside();
}

void Temporary::ForgetAside()
{
  if (this->Slot >= 0)
  {
    Entries[static_cast<std::size_t>(this->Slot)].Aside = false;
  }
}

void Temporary::Remove()
{
  if (this->File >= 0)
  {
    this->RemoveIntermediates();
    ::unlink((this->Path + MetadataSuffix).c_str());
    if (!this->Needed || ::ftruncate(this->File, 0) != 0)
    {
      ::unlink(this->Path.c_str());
    }
    ::close(this->File);
  }
  if (this->Slot >= 0)
  {
    Entries[static_cast<std::size_t>(this->Slot)].State = Entry::Free;
  }
  this->File = -1;
  this->Slot = -1;
}

std::string TemporaryFolder()
{
  const char* folder = std::getenv("TMPDIR");
  return folder && *folder ? folder : "/tmp";
}

void SweepTemporaries(const std::string& folder) noexcept
try
{
  const int before = errno;
  DIR* entries = ::opendir(folder.c_str());
  if (entries)
  {
    const int file = ::dirfd(entries);
    std::vector<std::string> names, asides;
    while (const dirent* entry = ::readdir(entries))
    {
      const std::string name = entry->d_name;
      if (name.rfind(NameBegin, 0) == 0 && name.find(NameMiddle) != std::string::npos)
      {
        (name.find(AsideMiddle) == std::string::npos ? names : asides).push_back(name);
      }
    }
    for (const std::string& name : asides)
    {
      SweepAside(file, name);
    }
    for (const std::string& name : names)
    {
      SweepName(file, name, asides);
    }
    ::closedir(entries);
  }
  errno = before;
}
catch (...)
{
  // There is no memory for a name; a later run removes the file.
}

void RemoveTemporaries() noexcept
{
  for (Entry& entry : Entries)
  {
    if (entry.State != Entry::Used || entry.Owner != ::getpid())
    {
      continue;
    }
    char path[PATH_MAX];
    const std::size_t length = std::strlen(entry.Path);
    std::memcpy(path, entry.Path, length + 1);
    // After the unlink, the temporary cannot be renamed to the target any more. If it was renamed
    // before, its side files belong to a raster that no longer exists.
    const bool removed = ::unlink(path) == 0;
    for (const char* suffix : SideFiles)
    {
      if (!entry.Aside)
      {
        break;
      }
      char aside[LongestAside], name[LongestAside];
      NameAside(aside, entry.Path, entry.Target, suffix);
      Append(Append(name, entry.Target), suffix);
      (void)(removed ? ::rename(aside, name) : ::unlink(aside));
    }
    for (const char* suffix : Suffixes)
    {
      std::memcpy(path + length, suffix, std::strlen(suffix) + 1);
      ::unlink(path);
    }
  }
}

} // namespace skyline
