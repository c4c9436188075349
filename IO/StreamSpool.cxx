// SPDX-License-Identifier: BSD-3-Clause
#include "StreamSpool.h"

#include "IoFailure.h"
#include "Temporaries.h"

#include "vtkErrorCode.h"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <mutex>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace skyline
{

namespace
{

constexpr int PollMilliseconds = 100;
constexpr std::size_t ChunkBytes = std::size_t(1) << 20;

bool IsStandardInput(const std::string& file)
{
  return file == "/vsistdin/" || file == "/vsistdin" || file == "/dev/stdin" ||
    file == "/dev/fd/0" || file == "/proc/self/fd/0" || file.rfind("/vsistdin?", 0) == 0;
}

[[noreturn]] void Fail(const std::string& file, const std::string& reason)
{
  throw IoFailure(vtkErrorCode::CannotOpenFileError, "cannot read '" + file + "': " + reason);
}

class Descriptor
{
public:
  explicit Descriptor(int number)
    : Number(number)
  {
  }
  ~Descriptor()
  {
    if (this->Number > 2)
    {
      ::close(this->Number);
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int Get() const { return this->Number; }
  int Release()
  {
    const int number = this->Number;
    this->Number = -1;
    return number;
  }

private:
  int Number;
};

/// Opens a file that is removed when its descriptor is closed.
int OpenTemporary()
{
  const std::string where = TemporaryFolder();
  int file = -1;
#ifdef O_TMPFILE
  file = ::open(where.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
#endif
  if (file < 0)
  {
    std::string name = where + "/skyline-XXXXXX";
    file = ::mkostemp(name.data(), O_CLOEXEC);
    if (file >= 0)
    {
      ::unlink(name.c_str());
    }
  }
  return file;
}

int OpenStream(const std::string& file)
{
  if (IsStandardInput(file))
  {
    return STDIN_FILENO;
  }
  // Without O_NONBLOCK, opening a named pipe that nobody writes would wait forever.
  const int stream = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (stream < 0)
  {
    Fail(file, std::string(std::strerror(errno)) + "; check the path");
  }
  return stream;
}

/// Refuses devices, because they have no end: /dev/zero would fill the disk.
void CheckKind(const std::string& file, int stream)
{
  struct stat status = {};
  if (::fstat(stream, &status) != 0)
  {
    Fail(file, std::string(std::strerror(errno)) + "; check what it is connected to");
  }
  if ((S_ISCHR(status.st_mode) && ::isatty(stream) == 0) || S_ISDIR(status.st_mode))
  {
    Fail(file, "it is a device or a folder; give a file or a pipe");
  }
}

/// True if standard input is a regular file that is read from its first byte.
bool IsWholeFile(int stream)
{
  struct stat status = {};
  return stream == STDIN_FILENO && ::fstat(stream, &status) == 0 && S_ISREG(status.st_mode) &&
    ::lseek(stream, 0, SEEK_CUR) == 0;
}

bool IsPipe(int stream)
{
  struct stat status = {};
  return ::fstat(stream, &status) == 0 && S_ISFIFO(status.st_mode);
}

/// Waits for bytes or the end of the stream. Returns false after `patience` seconds.
bool Wait(const std::string& file, int stream, double patience, const std::function<bool()>& goOn)
{
  const auto begin = std::chrono::steady_clock::now();
  for (;;)
  {
    struct pollfd poll = { stream, POLLIN, 0 };
    const int ready = ::poll(&poll, 1, PollMilliseconds);
    if (ready > 0)
    {
      return true;
    }
    if (!goOn())
    {
      throw IoAborted();
    }
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - begin;
    if (waited.count() > patience)
    {
      return false;
    }
    if (waited.count() > StreamSpool::SilencePatience)
    {
      Fail(file,
        "no data arrived for " + std::to_string(static_cast<int>(StreamSpool::SilencePatience)) +
          " s; write its bytes to a file first");
    }
  }
}

void Copy(const std::string& file, int stream, int target, const std::function<bool()>& goOn)
{
  std::vector<char> chunk(ChunkBytes);
  bool started = false;
  // A named pipe may have no writer; only a read shows this.
  bool hasWriter = stream == STDIN_FILENO || !IsPipe(stream);
  for (;;)
  {
    const bool ready = Wait(file, stream,
      hasWriter ? std::numeric_limits<double>::infinity() : StreamSpool::WriterPatience, goOn);
    const ssize_t count = ::read(stream, chunk.data(), chunk.size());
    if (count == 0)
    {
      if (!ready)
      {
        Fail(file,
          "it is a pipe to which no program wrote for " +
            std::to_string(static_cast<int>(StreamSpool::WriterPatience)) +
            " s; start the program that writes to it first");
      }
      break;
    }
    hasWriter = true;
    if (count < 0)
    {
      if (errno == EINTR || errno == EAGAIN)
      {
        continue;
      }
      Fail(file, std::string(std::strerror(errno)) + "; write its bytes to a file first");
    }
    started = true;
    for (ssize_t done = 0; done < count;)
    {
      const ssize_t written =
        ::write(target, chunk.data() + done, static_cast<std::size_t>(count - done));
      if (written < 0 && errno != EINTR)
      {
        Fail(file,
          std::string("its bytes cannot be kept in the temporary folder: ") + std::strerror(errno) +
            "; set TMPDIR to a folder with space");
      }
      done += written > 0 ? written : 0;
    }
    if (!goOn())
    {
      throw IoAborted();
    }
  }
  if (!started)
  {
    Fail(file, "it is empty; write a raster into it");
  }
}

} // namespace

bool StreamSpool::IsStream(const std::string& file)
{
  struct stat status = {};
  return IsStandardInput(file) ||
    (::stat(file.c_str(), &status) == 0 && (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode)));
}

std::shared_ptr<StreamSpool> StreamSpool::Read(
  const std::string& file, const std::function<bool()>& goOn)
{
  static std::mutex mutex; // for standard input, which is read once
  static std::shared_ptr<StreamSpool> input;
  std::unique_lock<std::mutex> lock(mutex, std::defer_lock);
  if (IsStandardInput(file))
  {
    lock.lock();
  }
  if (lock.owns_lock() && input)
  {
    return input;
  }
  const Descriptor stream(OpenStream(file));
  CheckKind(file, stream.Get());
  if (IsWholeFile(stream.Get()))
  {
    const int again = ::open("/proc/self/fd/0", O_RDONLY | O_CLOEXEC);
    if (again >= 0)
    {
      return std::shared_ptr<StreamSpool>(new StreamSpool(again)); // the bytes are there already
    }
  }
  Descriptor target(OpenTemporary());
  if (target.Get() < 0)
  {
    Fail(file,
      std::string("its bytes cannot be kept in the temporary folder: ") + std::strerror(errno) +
        "; set TMPDIR to a folder that can be written");
  }
  Copy(file, stream.Get(), target.Get(), goOn);
  std::shared_ptr<StreamSpool> spool(new StreamSpool(target.Release()));
  if (IsStandardInput(file))
  {
    input = spool;
  }
  return spool;
}

StreamSpool::~StreamSpool()
{
  ::close(this->File);
}

std::string StreamSpool::GetName() const
{
  return "/proc/self/fd/" + std::to_string(this->File);
}

} // namespace skyline
