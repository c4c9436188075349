// SPDX-License-Identifier: BSD-3-Clause
#include "GuardedVsi.h"

#include "SourceGuard.h"

#include <cpl_string.h>
#include <cpl_vsi_virtual.h>

#include <cerrno>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace skyline
{

namespace
{

/// A wrapper of one of GDAL's file systems that asks the guard first. Calls without a file name are
/// passed on unchanged.
class GuardedSystem : public VSIFilesystemHandler
{
public:
  using Opened = decltype(std::declval<VSIFilesystemHandler&>().Open(
    "", "", false, static_cast<CSLConstList>(nullptr)));

  GuardedSystem(std::string prefix, VSIFilesystemHandler* inner)
    : Prefix(std::move(prefix))
    , Network(IsNetwork(this->Prefix))
    , Inner(inner)
  {
  }

  VSIFilesystemHandler* GetInner() const { return this->Inner; }

  Opened Open(const char* name, const char* access, bool setError, CSLConstList options) override
  {
    const bool create = access && std::string(access).find_first_of("wa") != std::string::npos;
    const GuardedCall call(*this, name, create);
    return call.Allowed ? this->Inner->Open(name, access, setError, options) : Opened();
  }
  int Stat(const char* name, VSIStatBufL* status, int flags) override
  {
    const GuardedCall call(*this, name);
    return call.Allowed ? this->Inner->Stat(name, status, flags) : -1;
  }
  char** ReadDirEx(const char* name, int most) override
  {
    const GuardedCall call(*this, name);
    return call.Allowed ? this->Inner->ReadDirEx(name, most) : nullptr;
  }
  char** SiblingFiles(const char* name) override
  {
    const GuardedCall call(*this, name);
    return call.Allowed ? this->Inner->SiblingFiles(name) : nullptr;
  }
  VSIDIR* OpenDir(const char* name, int depth, const char* const* options) override
  {
    const GuardedCall call(*this, name);
    return call.Allowed ? this->Inner->OpenDir(name, depth, options) : nullptr;
  }
  char** GetFileMetadata(const char* name, const char* domain, CSLConstList options) override
  {
    const GuardedCall call(*this, name);
    return call.Allowed ? this->Inner->GetFileMetadata(name, domain, options) : nullptr;
  }
  int Unlink(const char* name) override
  {
    const GuardedCall call(*this, name);
    return call.Allowed ? this->Inner->Unlink(name) : -1;
  }
  int Rename(const char* from, const char* to) override
  {
    const GuardedCall call(*this, from), other(*this, to, true);
    return call.Allowed && other.Allowed ? this->Inner->Rename(from, to) : -1;
  }
  int Mkdir(const char* name, long mode) override
  {
    const GuardedCall call(*this, name, true);
    return call.Allowed ? this->Inner->Mkdir(name, mode) : -1;
  }
  int Rmdir(const char* name) override
  {
    const GuardedCall call(*this, name);
    return call.Allowed ? this->Inner->Rmdir(name) : -1;
  }
  int IsCaseSensitive(const char* name) override { return this->Inner->IsCaseSensitive(name); }
  GIntBig GetDiskFreeSpace(const char* name) override
  {
    return this->Inner->GetDiskFreeSpace(name);
  }
  int SupportsSparseFiles(const char* name) override
  {
    return this->Inner->SupportsSparseFiles(name);
  }
  int HasOptimizedReadMultiRange(const char* name) override
  {
    return this->Inner->HasOptimizedReadMultiRange(name);
  }
  const char* GetActualURL(const char* name) override { return this->Inner->GetActualURL(name); }
  const char* GetOptions() override { return this->Inner->GetOptions(); }
  char* GetSignedURL(const char* name, CSLConstList options) override
  {
    const GuardedCall call(*this, name);
    return call.Allowed ? this->Inner->GetSignedURL(name, options) : nullptr;
  }
  std::string GetStreamingFilename(const std::string& name) const override
  {
    return this->Inner->GetStreamingFilename(name);
  }
  bool IsLocal(const char* name) override { return this->Inner->IsLocal(name); }
  bool SupportsSequentialWrite(const char* name, bool temporary) override
  {
    return this->Inner->SupportsSequentialWrite(name, temporary);
  }
  bool SupportsRandomWrite(const char* name, bool temporary) override
  {
    return this->Inner->SupportsRandomWrite(name, temporary);
  }
  bool SupportsRead(const char* name) override { return this->Inner->SupportsRead(name); }

private:
  /// One call. It asks the guard whether the call is allowed, and does not judge the files that the
  /// network code itself reads.
  struct GuardedCall
  {
    GuardedCall(const GuardedSystem& system, const char* name, bool create = false)
      : Guard(SourceGuard::GetCurrent())
    {
      if (!this->Guard)
      {
        return;
      }
      this->Before = this->Guard->Suspended;
      this->Allowed = system.Network ? this->Guard->MayUseNetwork(name)
        : system.Prefix.empty()      ? this->Guard->MayTouch(name, create)
                                     : this->Guard->MayUseSystem(system.Prefix.c_str(), name);
      this->Guard->Suspended = this->Before || system.Network;
      if (!this->Allowed)
      {
        errno = EACCES;
      }
    }
    ~GuardedCall()
    {
      if (this->Guard)
      {
        this->Guard->Suspended = this->Before;
      }
    }
    GuardedCall(const GuardedCall&) = delete;
    GuardedCall& operator=(const GuardedCall&) = delete;

    SourceGuard* Guard;
    bool Allowed = true;
    bool Before = false;
  };

  /// All file systems that are not on a local disk. For systems that are not known here, see
  /// MayUseSystem.
  static bool IsNetwork(const std::string& prefix)
  {
    for (const char* part : { "/vsicurl", "/vsis3", "/vsigs", "/vsiaz", "/vsiadls", "/vsioss",
           "/vsiswift", "/vsihdfs", "/vsiwebhdfs" })
    {
      if (prefix.rfind(part, 0) == 0)
      {
        return true;
      }
    }
    return false;
  }

  std::string Prefix; ///< empty for files on local disks
  bool Network;
  VSIFilesystemHandler* Inner;
};

/// The wrappers that replace GDAL's file systems, and the number of guards that need them.
struct Installed
{
  std::mutex Mutex;
  int Users = 0;
  std::map<std::pair<std::string, VSIFilesystemHandler*>, GuardedSystem*> Systems;
  std::map<std::string, GuardedSystem*> Active;

  static Installed& Get()
  {
    static auto* installed = new Installed; // not deleted: GDAL may need it at exit
    return *installed;
  }

  void Install()
  {
// From 3.12 on, GDAL deletes a file system that is replaced. With these versions the guard sees
// what is opened as a raster and what is read from the network, but not other files that format
// drivers read by themselves.
#if GDAL_VERSION_NUM < GDAL_COMPUTE_VERSION(3, 12, 0)
    const CPLStringList known(VSIFileManager::GetPrefixes());
    std::vector<std::string> prefixes{ "" };
    prefixes.insert(prefixes.end(), known.List(), known.List() + known.Count());
    prefixes.emplace_back("/vsicurl?"); // not listed by GDAL
    VSIFilesystemHandler* const disks = VSIFileManager::GetHandler("");
    for (const std::string& prefix : prefixes)
    {
      VSIFilesystemHandler* inner = VSIFileManager::GetHandler(prefix.c_str());
      if (inner == disks && !prefix.empty())
      {
        continue; // this file system does not exist here
      }
      if (SourceGuard::IsHarmless(prefix))
      {
        continue; // GDAL casts some of these to its own class without a check
      }
      GuardedSystem*& system = this->Systems[{ prefix, inner }];
      if (!system)
      {
        system = new GuardedSystem(prefix, inner);
      }
      this->Active[prefix] = system;
    }
    for (const auto& [prefix, system] : this->Active)
    {
      VSIFileManager::InstallHandler(prefix, system);
    }
#endif
  }

  void Remove()
  {
#if GDAL_VERSION_NUM < GDAL_COMPUTE_VERSION(3, 12, 0)
    for (const auto& [prefix, system] : this->Active)
    {
      if (VSIFileManager::GetHandler(prefix.c_str()) == system)
      {
        VSIFileManager::InstallHandler(prefix, system->GetInner());
      }
    }
#endif
    this->Active.clear();
  }
};

} // namespace

void AcquireVsi()
{
  Installed& installed = Installed::Get();
  const std::lock_guard<std::mutex> lock(installed.Mutex);
  if (installed.Users++ == 0)
  {
    installed.Install();
  }
}

void ReleaseVsi()
{
  Installed& installed = Installed::Get();
  const std::lock_guard<std::mutex> lock(installed.Mutex);
  if (--installed.Users == 0)
  {
    installed.Remove();
  }
}

} // namespace skyline
