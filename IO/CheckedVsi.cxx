// SPDX-License-Identifier: BSD-3-Clause
#include "CheckedVsi.h"

#include "CheckedFile.h"

#include <cpl_vsi.h>

#include <algorithm>
#include <cstdio>
#include <list>
#include <mutex>
#include <utility>

#include <sys/stat.h>
#include <unistd.h>

namespace skyline
{

namespace
{

/// The prefix of the names. GDAL removes it from names and keeps the pointer.
constexpr const char* Prefix = "/vsiskyline/";

using ErrorCell = std::shared_ptr<std::atomic<int>>;

/// The paths that a CheckedVsi watches at the moment.
struct Watches
{
  std::mutex Mutex;
  std::list<std::pair<std::string, ErrorCell>> List;

  static Watches& Get()
  {
    static Watches watches;
    return watches;
  }

  ErrorCell Find(const std::string& path)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    for (const auto& [begin, error] : this->List)
    {
      if (path.compare(0, begin.size(), begin) == 0)
      {
        return error;
      }
    }
    return nullptr;
  }
};

/// The file handle that GDAL gets.
struct Handle
{
  Handle(const std::string& path, const std::string& access, ErrorCell error)
    : File(path, access)
    , Error(std::move(error))
  {
  }

  void Tell()
  {
    int none = 0;
    if (this->Error && this->File.GetError() != 0)
    {
      this->Error->compare_exchange_strong(none, this->File.GetError());
    }
  }

  CheckedFile File;
  ErrorCell Error;
  std::int64_t Position = 0;
  bool AtEnd = false;
};

Handle& Of(void* file)
{
  return *static_cast<Handle*>(file);
}

std::string PathOf(const char* name)
{
  return "/" + std::string(name);
}

void* Open(void*, const char* name, const char* access)
{
  const std::string path = PathOf(name);
  auto handle = std::make_unique<Handle>(path, access, Watches::Get().Find(path));
  if (!handle->File.IsOpen())
  {
    if (std::string(access).find('w') != std::string::npos)
    {
      handle->Tell();
    }
    return nullptr;
  }
  return handle.release();
}

vsi_l_offset Tell(void* file)
{
  return static_cast<vsi_l_offset>(Of(file).Position);
}

int Seek(void* file, vsi_l_offset offset, int whence)
{
  Handle& handle = Of(file);
  const auto distance = static_cast<std::int64_t>(offset);
  handle.AtEnd = false;
  handle.Position = whence == SEEK_SET ? distance
    : whence == SEEK_CUR               ? handle.Position + distance
                                       : handle.File.GetSize() + distance;
  return 0;
}

std::size_t Read(void* file, void* bytes, std::size_t size, std::size_t count)
{
  Handle& handle = Of(file);
  const std::size_t done = handle.File.Read(bytes, size * count, handle.Position);
  handle.Position += static_cast<std::int64_t>(done);
  handle.AtEnd = done < size * count;
  return size > 0 ? done / size : 0;
}

int Eof(void* file)
{
  return Of(file).AtEnd ? 1 : 0;
}

std::size_t Write(void* file, const void* bytes, std::size_t size, std::size_t count)
{
  Handle& handle = Of(file);
  handle.File.Write(bytes, size * count, handle.Position);
  handle.Position += static_cast<std::int64_t>(size * count);
  handle.Tell();
  return count;
}

int Truncate(void* file, vsi_l_offset size)
{
  Of(file).File.Truncate(static_cast<std::int64_t>(size));
  Of(file).Tell();
  return 0;
}

int Flush(void*)
{
  return 0; // nothing is buffered here
}

int Close(void* file)
{
  const std::unique_ptr<Handle> handle(static_cast<Handle*>(file));
  handle->File.Close();
  handle->Tell();
  return 0;
}

int Stat(void*, const char* name, VSIStatBufL* status, int)
{
  return ::stat64(PathOf(name).c_str(), status);
}

int Unlink(void*, const char* name)
{
  return ::unlink(PathOf(name).c_str());
}

void Install()
{
  static std::once_flag installed;
  std::call_once(installed,
    []
    {
      VSIFilesystemPluginCallbacksStruct* calls = VSIAllocFilesystemPluginCallbacksStruct();
      calls->open = Open;
      calls->tell = Tell;
      calls->seek = Seek;
      calls->read = Read;
      calls->eof = Eof;
      calls->write = Write;
      calls->truncate = Truncate;
      calls->flush = Flush;
      calls->close = Close;
      calls->stat = Stat;
      calls->unlink = Unlink;
      VSIInstallPluginHandler(Prefix, calls);
      VSIFreeFilesystemPluginCallbacksStruct(calls);
    });
}

} // namespace

CheckedVsi::CheckedVsi(const std::string& path)
  : Path(path)
  , Error(std::make_shared<std::atomic<int>>(0))
{
  Install();
  Watches& watches = Watches::Get();
  const std::lock_guard<std::mutex> lock(watches.Mutex);
  watches.List.emplace_back(this->Path, this->Error);
}

CheckedVsi::~CheckedVsi()
{
  Watches& watches = Watches::Get();
  const std::lock_guard<std::mutex> lock(watches.Mutex);
  watches.List.remove_if([this](const auto& entry) { return entry.second == this->Error; });
}

std::string CheckedVsi::NameOf(const std::string& path)
{
  return Prefix + path.substr(1);
}

} // namespace skyline
