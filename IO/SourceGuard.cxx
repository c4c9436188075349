// SPDX-License-Identifier: BSD-3-Clause
#include "SourceGuard.h"

#include "GuardedVsi.h"
#include "NetcdfHeader.h"

#include <cpl_http.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <mutex>
#include <system_error>

namespace skyline
{

namespace
{

namespace fs = std::filesystem;

thread_local SourceGuard* Current = nullptr;

/// The original open functions of a driver whose functions Gate replaces.
struct Opener
{
  GDALDataset* (*Open)(GDALOpenInfo*) = nullptr;
  GDALDataset* (*OpenWithDriver)(GDALDriver*, GDALOpenInfo*) = nullptr;
};
std::mutex OpenersMutex;
std::map<GDALDriver*, Opener>& Openers()
{
  static auto* openers = new std::map<GDALDriver*, Opener>; // never deleted, as GDAL itself
  return *openers;
}

/// The path without links and dots. If the path does not exist, the part that exists is resolved.
std::string Canonical(const std::string& path)
{
  std::error_code failed;
  const fs::path absolute = fs::absolute(path, failed);
  const fs::path canonical = fs::weakly_canonical(absolute, failed);
  return failed ? absolute.lexically_normal().string() : canonical.string();
}

/// Characters that may enclose a path in GDAL's longer names: NETCDF:"a.nc":z.
constexpr const char* Edges = ":\"'{}<>?,= ";

/// True if a name tells a library to contact a server itself, as NETCDF:"http://..." does; not
/// HDF5:"a.h5"://z.
bool HasUrl(const std::string& name)
{
  for (std::size_t at = name.find("://"); at != std::string::npos; at = name.find("://", at + 1))
  {
    std::size_t begin = at;
    while (begin > 0 && std::isalnum(static_cast<unsigned char>(name[begin - 1])))
    {
      --begin;
    }
    const std::string scheme = name.substr(begin, at - begin);
    if (!scheme.empty() && scheme != "vrt")
    {
      return true;
    }
  }
  return false;
}

/// The folder in which GDAL and its formats keep their own tables.
std::string DataFolder()
{
  const char* found = CPLFindFile("gdal", "gdalvrt.xsd");
  return found ? CPLGetDirname(found) : "";
}

/// Sets an error silently. Without an error, GDAL would try the next driver.
void QuietFailure(const std::string& name)
{
  CPLPushErrorHandler(CPLQuietErrorHandler);
  CPLError(CE_Failure, CPLE_OpenFailed, "no allowed driver opens '%s'", name.c_str());
  CPLPopErrorHandler();
}

CPLHTTPResult* RefuseFetch(
  const char* url, CSLConstList, GDALProgressFunc, void*, CPLHTTPFetchWriteFunc, void*, void*)
{
  SourceGuard* guard = SourceGuard::GetCurrent();
  if (!guard || guard->MayUseNetwork(url))
  {
    return nullptr; // GDAL fetches the data
  }
  auto* result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
  result->nStatus = 1;
  result->pszErrBuf = CPLStrdup("the network is not allowed");
  return result;
}

} // namespace

SourceGuard::SourceGuard(
  const std::string& file, const SourcePolicy& policy, const std::string& folder)
  : File(file)
  , Policy(policy)
  , DriverNames(AllowedDrivers(policy))
  , Outer(Current)
{
  for (const std::string& name : this->DriverNames)
  {
    this->Drivers.AddString(name.c_str());
  }
  static const std::string data = DataFolder();
  for (const std::string& own : { folder, data, std::string(CPLGetConfigOption("GDAL_DATA", "")),
         std::string(CPLGetConfigOption("GRIB_RESOURCE_DIR", "")),
         std::string(CPLGetConfigOption("GDAL_PAM_PROXY_DIR", "")) })
  {
    this->AddFolder(own);
  }
  GDALGetCacheMax64(); // GDAL inspects the machine here, once
  HookFirstDriver();
  AcquireVsi();
  CPLHTTPPushFetchCallback(&RefuseFetch, nullptr);
  Current = this;
}

SourceGuard::~SourceGuard()
{
  Current = this->Outer;
  CPLHTTPPopFetchCallback();
  ReleaseVsi();
}

SourceGuard* SourceGuard::GetCurrent()
{
  return Current;
}

void SourceGuard::HookFirstDriver()
{
  const std::lock_guard<std::mutex> lock(OpenersMutex);
  GDALDriver* first = GetGDALDriverManager()->GetDriver(0);
  if (first && first->pfnOpenWithDriverArg != &SourceGuard::Gate)
  {
    Openers()[first] = { first->pfnOpen, first->pfnOpenWithDriverArg };
    first->pfnOpenWithDriverArg = &SourceGuard::Gate;
    first->pfnOpen = nullptr;
  }
}

/// Replaces the open function of the driver that GDAL asks first, so that it is called for each
/// name that is opened, wherever the name comes from.
GDALDataset* SourceGuard::Gate(GDALDriver* driver, GDALOpenInfo* info)
{
  if (Current)
  {
    if (Current->Passing != info->pszFilename)
    {
      return Current->OpenNested(info);
    }
    Current->Passing.clear();
  }
  Opener opener;
  {
    const std::lock_guard<std::mutex> lock(OpenersMutex);
    opener = Openers()[driver];
  }
  return opener.Open        ? opener.Open(info)
    : opener.OpenWithDriver ? opener.OpenWithDriver(driver, info)
                            : nullptr;
}

/// Opens a raster in place of GDAL, which would try every driver.
GDALDataset* SourceGuard::OpenNested(GDALOpenInfo* info)
{
  const std::string name = info->pszFilename;
  if (!this->MayOpen(name))
  {
    QuietFailure(name);
    return nullptr;
  }
  const unsigned flags = static_cast<unsigned>(info->nOpenFlags) & ~unsigned(GDAL_OF_SHARED);
  this->Passing = name;
  auto* dataset = static_cast<GDALDataset*>(
    GDALOpenEx(name.c_str(), flags, this->Drivers.List(), info->papszOpenOptions, nullptr));
  this->Passing.clear();
  if (!dataset)
  {
    this->Refuse(this->DriverRefusal(name));
    if (CPLGetLastErrorType() < CE_Failure)
    {
      QuietFailure(name);
    }
  }
  return dataset;
}

/// True if a driver may read the path.
bool SourceGuard::MayRead(const std::string& path)
{
  if (!this->MayTouch(path.c_str()))
  {
    return false;
  }
  std::error_code failed;
  if (!fs::is_regular_file(path, failed) || NetcdfHeaderFits(path))
  {
    return true;
  }
  this->Refuse((path == this->File ? "its" : "it refers to '" + path + "', whose") +
    std::string(" netCDF header declares more data than the file holds; fetch the file again"));
  return false;
}

/// Judges names that libraries open without GDAL's file systems: paths and URLs inside longer
/// names.
bool SourceGuard::MayOpen(const std::string& name)
{
  if (!name.empty() && name[0] == '<')
  {
    return true; // the XML of a virtual raster; its sources are judged when they are opened
  }
  if (HasUrl(name) && !this->MayUseNetwork(name.c_str()))
  {
    return false;
  }
  std::error_code failed;
  if (fs::exists(name, failed))
  {
    return this->MayRead(name); // a single path, whatever characters it contains
  }
  for (std::size_t begin = 0; begin < name.size();)
  {
    const std::size_t end = std::min(name.find_first_of(Edges, begin), name.size());
    if (end > begin && !this->MayRead(name.substr(begin, end - begin)))
    {
      return false;
    }
    begin = end + 1;
  }
  return true;
}

GDALDataset* SourceGuard::Open(const std::string& name)
{
  if (!this->MayOpen(name))
  {
    return nullptr;
  }
  this->Passing = name;
  auto* dataset = static_cast<GDALDataset*>(
    GDALOpenEx(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
      this->Drivers.List(), nullptr, nullptr));
  this->Passing.clear();
  return dataset;
}

std::string SourceGuard::DriverRefusal(const std::string& name)
{
  GDALDriverH driver = GDALIdentifyDriverEx(name.c_str(), GDAL_OF_RASTER, nullptr, nullptr);
  const std::string kind = driver ? GDALGetDriverShortName(driver) : "";
  const auto allowed = [&](const std::string& one) { return EQUAL(one.c_str(), kind.c_str()); };
  if (kind.empty() || std::any_of(this->DriverNames.begin(), this->DriverNames.end(), allowed))
  {
    return "";
  }
  const std::string what = name == this->File ? "it is" : "it refers to '" + name + "',";
  return what + " of the format " + kind + ", which is not opened by default; use --driver " +
    kind + " if you trust it (and --allow-network if it lies on a server)";
}

void SourceGuard::Refuse(const std::string& reason)
{
  if (this->Refusal.empty())
  {
    this->Refusal = reason.substr(0, reason.find_first_of("\r\n"));
  }
}

bool SourceGuard::MayUseNetwork(const char* name)
{
  if (!this->Policy.AllowNetwork)
  {
    const std::string what = name;
    this->Refuse((what == this->File ? "it lies on the network"
                                     : "it refers to '" + what + "' on the network") +
      "; use --allow-network if you trust it");
  }
  return this->Policy.AllowNetwork;
}

bool SourceGuard::IsHarmless(const std::string& prefix)
{
  const auto systems = { "/vsimem/", "/vsizip/", "/vsigzip/", "/vsitar/", "/vsi7z/", "/vsirar/",
    "/vsisubfile/", "/vsisparse/", "/vsicrypt/", "/vsicached?" };
  return std::find(systems.begin(), systems.end(), prefix) != systems.end();
}

bool SourceGuard::MayUseSystem(const char* prefix, const char* name)
{
  // The user named this file system in the file name, so that its files may belong to his program.
  if (this->Policy.AllowElsewhere || this->File.find(prefix) != std::string::npos)
  {
    return true;
  }
  this->Refuse("it refers to '" + std::string(name) +
    "', outside its folder; use --allow-elsewhere if you trust it");
  return false;
}

bool SourceGuard::MayTouch(const char* path, bool create)
{
  const std::string name = path ? path : "";
  if (this->Suspended || name.empty())
  {
    return true;
  }
  if (this->SpellsOut(name))
  {
    this->AddFolderOf(name);
    return true;
  }
  std::error_code failed;
  const fs::file_status status = fs::status(name, failed);
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
  {
    // Opening a pipe that nobody writes would wait forever.
    this->Refuse("it refers to '" + name + "', a pipe or a device; name a regular file in it");
    return false;
  }
  if (this->Policy.AllowElsewhere)
  {
    return true;
  }
  if (this->IsBelow(name) || (!create && !fs::exists(fs::symlink_status(name, failed))))
  {
    return true; // a file of GDAL itself, or no file at all
  }
  // GDAL reads these files to find out how much memory it may use.
  const bool machine = name.rfind("/sys/fs/cgroup", 0) == 0 || name == "/proc/self/status" ||
    name == "/proc/meminfo" || name == "/proc/self/cgroup";
  if (!machine)
  {
    this->Refuse(
      "it refers to '" + name + "', outside its folder; use --allow-elsewhere if you trust it");
  }
  return false;
}

bool SourceGuard::SpellsOut(const std::string& path) const
{
  std::error_code missing;
  if (fs::exists(this->File, missing))
  {
    return path == this->File; // a single path, whatever characters it contains
  }
  for (std::size_t at = this->File.find(path); at != std::string::npos;
       at = this->File.find(path, at + 1))
  {
    const std::size_t end = at + path.size();
    std::string edges = Edges;
    edges += this->File.rfind("/vsi", 0) == 0 ? "/" : ""; // a path after a system's prefix
    const bool begins = at == 0 || edges.find(this->File[at - 1]) != std::string::npos ||
      (at >= 3 && this->File.compare(at - 3, 3, "://") == 0); // as in vrt://dem.tif
    const bool ends = end == this->File.size() || edges.find(this->File[end]) != std::string::npos;
    if (begins && ends)
    {
      // If the path continues here, only an archive can end here.
      std::error_code failed;
      const bool within = end < this->File.size() && this->File[end] == '/';
      return !within || fs::is_regular_file(path, failed);
    }
  }
  return false;
}

void SourceGuard::AddFolder(const std::string& folder)
{
  if (!folder.empty())
  {
    std::string canonical = Canonical(folder);
    canonical += canonical.back() == '/' ? "" : "/";
    if (std::find(this->Folders.begin(), this->Folders.end(), canonical) == this->Folders.end())
    {
      this->Folders.push_back(canonical);
    }
  }
}

void SourceGuard::AddFolderOf(const std::string& path)
{
  std::error_code failed;
  if (fs::is_directory(path, failed))
  {
    this->AddFolder(path);
  }
  else if (fs::exists(path, failed))
  {
    const fs::path absolute = fs::absolute(path, failed);
    this->AddFolder(absolute.parent_path().string());
    this->AddFolder(fs::path(Canonical(path)).parent_path().string());
  }
  else
  {
    return;
  }
  // An Arc/Info coverage keeps its tables in a folder beside its own.
  for (const std::string& folder : std::vector<std::string>(this->Folders))
  {
    if (fs::exists(folder + "hdr.adf", failed))
    {
      this->AddFolder(folder + "../info");
    }
  }
}

bool SourceGuard::IsBelow(const std::string& path) const
{
  const std::string canonical = Canonical(path);
  return std::any_of(this->Folders.begin(), this->Folders.end(),
    [&](const std::string& folder)
    {
      if (folder == "/") // every path is below the root
      {
        return canonical.find('/', 1) == std::string::npos;
      }
      return (canonical + "/").compare(0, folder.size(), folder) == 0;
    });
}

} // namespace skyline
