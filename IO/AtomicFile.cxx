// SPDX-License-Identifier: BSD-3-Clause
#include "AtomicFile.h"

#include "IoFailure.h"

#include "vtkErrorCode.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/xattr.h>
#include <unistd.h>

namespace skyline
{

namespace
{

/// The file system counts as full if it has less free space than this, in bytes. Writers need about
/// as much for one step.
constexpr double NoSpace = 64.0 * 1024;

/// The greatest number of symbolic links that the system follows for one path (Linux:
/// path_resolution(7)).
constexpr int MostLinks = 40;

/// The greatest length of an extension in characters; those of the written files are shorter.
constexpr std::size_t LongestExtension = 32;

/// The attribute in which Linux stores the access control list of a file. It is copied without
/// being read.
constexpr const char* AccessList = "system.posix_acl_access";

/// The absolute path without links, dots and double slashes, or `path` itself if it does not exist.
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

/// The extension with its dot, or "" if the text after the last dot does not look like one.
std::string ExtensionOf(const std::string& path)
{
  const std::size_t dot = path.find_last_of("./");
  const bool usable =
    dot != std::string::npos && path[dot] == '.' && path.size() - dot <= LongestExtension;
  return usable ? path.substr(dot) : "";
}

/// N if the path is descriptor N of this process in /proc, else -1.
int DescriptorOf(const std::string& path)
{
  const std::string name = path.substr(path.rfind('/') + 1);
  if (name.empty() || name.size() > 9 || name.find_first_not_of("0123456789") != std::string::npos)
  {
    return -1;
  }
  const std::string folder = RealPath(FolderOf(path));
  const bool own =
    folder == RealPath("/proc/self/fd") || folder == RealPath("/proc/thread-self/fd");
  return own ? static_cast<int>(std::strtol(name.c_str(), nullptr, 10)) : -1;
}

unsigned long CodeFor(int error)
{
  const bool full = error == ENOSPC || error == EDQUOT || error == EFBIG;
  return full ? vtkErrorCode::OutOfDiskSpaceError : vtkErrorCode::CannotOpenFileError;
}

const char* AdviceFor(int error)
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
    case ENXIO:
      return " (no program reads from it); start the program that reads it";
    default:
      return "; choose another place";
  }
}

} // namespace

AtomicFile::AtomicFile(const std::string& target)
  : Target(target)
{
  this->Find();
  this->Reserve();
}

AtomicFile::~AtomicFile() = default;

/// Follows the symbolic links of the target to the file that they name.
void AtomicFile::Find()
{
  struct stat status;
  const bool there = ::stat(this->Target.c_str(), &status) == 0;
  if (!there && errno != ENOENT)
  {
    this->Fail(errno); // for instance a link that the system refuses to follow
  }
  this->Real = this->Target;
  std::array<char, 4096> link;
  for (int links = 0; links < MostLinks; ++links)
  {
    this->Descriptor = DescriptorOf(this->Real);
    const ssize_t length =
      this->Descriptor >= 0 ? -1 : ::readlink(this->Real.c_str(), link.data(), link.size());
    if (length < 0)
    {
      break;
    }
    const std::string next(link.data(), static_cast<std::size_t>(length));
    this->Real = next[0] == '/' ? next : FolderOf(this->Real) + "/" + next;
  }
  if (!there)
  {
    return;
  }
  if (S_ISDIR(status.st_mode))
  {
    this->Fail(EISDIR);
  }
  this->Device = this->Descriptor >= 0 || !S_ISREG(status.st_mode);
  const int flags = this->Descriptor < 0 ? O_WRONLY : ::fcntl(this->Descriptor, F_GETFL);
  if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY)
  {
    this->Fail(EBADF);
  }
  if (this->Descriptor < 0)
  {
    if (::access(this->Real.c_str(), W_OK) != 0)
    {
      this->Fail(errno);
    }
    this->Real = RealPath(this->Real);
  }
}

void AtomicFile::Reserve()
{
  const std::string temporary = RealPath(TemporaryFolder());
  const std::string folder = this->Device ? temporary : RealPath(FolderOf(this->Real));
  SweepTemporaries(folder);
  if (folder != temporary)
  {
    SweepTemporaries(temporary);
  }
  // A new file may be read by everyone whom the umask allows. A file that replaces another one, or
  // is copied elsewhere, is readable by its owner alone until it gets the permissions of its
  // target.
  const bool fresh = !this->Device && ::access(this->Real.c_str(), F_OK) != 0;
  this->File.emplace(folder, ExtensionOf(this->Target), fresh ? 0666 : 0600);
  if (!this->File->IsOpen())
  {
    const int error = errno;
    this->File.reset();
    this->Fail(error);
  }
}

std::string AtomicFile::GetIntermediatePath() const
{
  return this->GetPath() + IntermediateSuffix;
}

std::vector<std::string> AtomicFile::FilesToBeReplaced(const std::string& target)
{
  std::vector<std::string> files{ target };
  struct stat status;
  if (::stat(target.c_str(), &status) == 0 && S_ISREG(status.st_mode))
  {
    const std::string real = RealPath(target);
    for (const char* suffix : SideFiles)
    {
      files.push_back(real + suffix);
    }
  }
  return files;
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
  this->File->Remove();
}

void AtomicFile::Replace()
{
  this->KeepRights();
  // Some file systems report only here that they are full.
  if (::fsync(this->File->GetFile()) != 0 && errno != EINVAL)
  {
    this->Fail(errno);
  }
  // Intermediate files are removed before the rename. If the process were killed after the rename,
  // no later run could find their owner.
  this->File->RemoveIntermediates();
  // Side files are moved aside before the rename, because they would give the new raster a wrong
  // place and wrong values. They are moved back if the target cannot be replaced.
  const std::string stuck = this->File->PutAside(this->Real);
  if (!stuck.empty())
  {
    const int error = errno;
    throw IoFailure(CodeFor(error),
      "cannot write '" + this->Target + "': its side file '" + stuck +
        "' cannot be moved: " + std::strerror(error) + AdviceFor(error));
  }
  if (::rename(this->GetPath().c_str(), this->Real.c_str()) != 0)
  {
    const int error = errno;
    this->File->BringBack();
    this->Fail(error);
  }
  this->File->DropAside();
  const std::string side = this->GetPath() + ".aux.xml";
  if (::rename(side.c_str(), (this->Real + ".aux.xml").c_str()) != 0 && errno != ENOENT)
  {
    this->Fail(errno);
  }
  this->SyncFolder();
}

/// Gives the temporary the permissions of the file that it replaces, and its side file those of the
/// temporary. The new file never has more permissions than the old one. It has fewer if the user
/// may not grant all of them.
void AtomicFile::KeepRights()
{
  const int file = this->File->GetFile();
  struct stat old;
  if (::stat(this->Real.c_str(), &old) == 0)
  {
    const bool owned = ::fchown(file, old.st_uid, old.st_gid) == 0 ||
      ::fchown(file, static_cast<uid_t>(-1), old.st_gid) == 0;
    std::array<char, 4096> list;
    const ssize_t length = ::getxattr(this->Real.c_str(), AccessList, list.data(), list.size());
    bool listed = length < 0 && (errno == ENODATA || errno == ENOTSUP);
    if (listed)
    {
      (void)::fremovexattr(file, AccessList); // the list that the folder gives to new files
    }
    mode_t mode = old.st_mode & 0777;
    if (!owned)
    {
      mode &= ~070U | ((mode & 07U) << 3); // another group: only what everybody may do
    }
    else if (length >= 0)
    {
      listed = ::fsetxattr(file, AccessList, list.data(), static_cast<std::size_t>(length), 0) == 0;
    }
    if (!listed)
    {
      mode &= ~070U | ((mode & 07U) << 3); // the list is lost, and the group's bits were its mask
    }
    (void)::fchmod(file, mode);
  }
  struct stat now;
  if (::fstat(file, &now) == 0)
  {
    (void)::chmod((this->GetPath() + ".aux.xml").c_str(), now.st_mode & 0777);
  }
}

void AtomicFile::SyncFolder() const
{
  const int folder = ::open(FolderOf(this->Real).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const int error = folder < 0 || ::fsync(folder) == 0 ? 0 : errno;
  if (folder >= 0)
  {
    ::close(folder);
  }
  if (error == EIO)
  {
    this->Fail(error);
  }
}

int AtomicFile::OpenDevice() const
{
  if (this->Descriptor >= 0)
  {
    return ::fcntl(this->Descriptor, F_DUPFD_CLOEXEC, 0);
  }
  // Without O_NONBLOCK, opening a named pipe would wait forever for a reader.
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(PipePatience);
  int file = ::open(this->Real.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat status;
  while (file < 0 && errno == ENXIO && ::stat(this->Real.c_str(), &status) == 0 &&
    S_ISFIFO(status.st_mode) && std::chrono::steady_clock::now() < end)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    file = ::open(this->Real.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
  }
  if (file >= 0)
  {
    (void)::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) & ~O_NONBLOCK);
  }
  return file;
}

void AtomicFile::CopyToDevice()
{
  // From here on the file needs no name, so that even a killed process leaves nothing behind.
  const int from = ::fcntl(this->File->GetFile(), F_DUPFD_CLOEXEC, 0);
  (void)::lseek(from, 0, SEEK_SET);
  const int to = this->OpenDevice();
  int error = from < 0 || to < 0 ? errno : 0;
  this->File->Remove();
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

void AtomicFile::Fail(const std::string& reason) const
{
  struct statvfs space;
  if (this->File && ::statvfs(FolderOf(this->GetPath()).c_str(), &space) == 0 &&
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
    "cannot write '" + this->Target + "': " + std::strerror(error) + AdviceFor(error));
}

} // namespace skyline
