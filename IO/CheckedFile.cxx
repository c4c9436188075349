// SPDX-License-Identifier: BSD-3-Clause
#include "CheckedFile.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace skyline
{

namespace
{

int FlagsFor(const std::string& access)
{
  const bool both = access.find('+') != std::string::npos;
  if (access.find('w') != std::string::npos)
  {
    return O_CREAT | O_TRUNC | O_RDWR;
  }
  return both ? O_RDWR : O_RDONLY;
}

} // namespace

CheckedFile::CheckedFile(const std::string& path, const std::string& access)
  : File(::open(path.c_str(), FlagsFor(access) | O_CLOEXEC, 0600))
{
  struct stat status = {};
  this->Remember(this->File < 0 || ::fstat(this->File, &status) != 0);
  this->Size = status.st_size;
}

CheckedFile::~CheckedFile()
{
  this->Close();
}

void CheckedFile::Remember(bool failed)
{
  if (failed && this->Error == 0)
  {
    this->Error = errno;
  }
}

std::size_t CheckedFile::Read(void* bytes, std::size_t size, std::int64_t offset)
{
  const auto left = static_cast<std::size_t>(std::max<std::int64_t>(0, this->Size - offset));
  const std::size_t wanted = std::min(size, left);
  char* to = static_cast<char*>(bytes);
  std::size_t done = 0;
  while (done < wanted)
  {
    const ssize_t count =
      ::pread(this->File, to + done, wanted - done, offset + static_cast<std::int64_t>(done));
    if (count > 0)
    {
      done += static_cast<std::size_t>(count);
    }
    else if (count == 0 || errno != EINTR)
    {
      break;
    }
  }
  if (this->Error != 0)
  {
    std::memset(to + done, 0, wanted - done); // the bytes of writes that were ignored
    done = wanted;
  }
  return done;
}

void CheckedFile::Write(const void* bytes, std::size_t size, std::int64_t offset)
{
  const char* from = static_cast<const char*>(bytes);
  std::size_t done = 0;
  while (this->Error == 0 && done < size)
  {
    const ssize_t count =
      ::pwrite(this->File, from + done, size - done, offset + static_cast<std::int64_t>(done));
    if (count >= 0)
    {
      done += static_cast<std::size_t>(count);
    }
    else
    {
      this->Remember(errno != EINTR);
    }
  }
  this->Size = std::max(this->Size, offset + static_cast<std::int64_t>(size));
}

void CheckedFile::Truncate(std::int64_t size)
{
  if (this->Error == 0)
  {
    this->Remember(::ftruncate(this->File, size) != 0);
  }
  this->Size = size;
}

void CheckedFile::Close()
{
  if (this->File >= 0)
  {
    this->Remember(::close(this->File) != 0);
  }
  this->File = -1;
}

} // namespace skyline
