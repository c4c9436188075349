// SPDX-License-Identifier: BSD-3-Clause
// Prevents GDAL from reading, together with a file, other files or servers that the user did not
// choose.
#ifndef skyline_SourceGuard_h
#define skyline_SourceGuard_h

#include "SourcePolicy.h"

#include <cpl_conv.h>
#include <gdal_priv.h>

#include <string>
#include <vector>

namespace skyline
{

/// While an object of this class exists, each file that GDAL opens in this thread is checked
/// against a policy, at every depth: sources of a virtual raster, masks, overviews, files named
/// inside other formats. Other threads are not affected. It must be created and destroyed in the
/// same thread, in reverse order if there are several.
class SourceGuard
{
public:
  /// `file`: the name that the user asked for. Each file that this name contains is allowed, and so
  /// are the files in its folder and below. `folder`: a further allowed folder, or empty. Throws
  /// IoFailure for an unknown driver.
  SourceGuard(const std::string& file, const SourcePolicy& policy, const std::string& folder = "");
  ~SourceGuard();
  SourceGuard(const SourceGuard&) = delete;
  SourceGuard& operator=(const SourceGuard&) = delete;

  /// Opens a raster for reading with the drivers of the policy. Returns null on failure.
  GDALDataset* Open(const std::string& name);

  /// The first refusal, as the part of a sentence that follows the file name, with the option that
  /// allows the access; empty if nothing was refused.
  const std::string& GetRefusal() const { return this->Refusal; }

  /// The refusal if only a driver outside the policy can open `name`, else empty.
  std::string DriverRefusal(const std::string& name);

  /// The guard of this thread, or null if there is none.
  static SourceGuard* GetCurrent();

  /// True if a file on a local disk may be opened; the two other functions decide the same for
  /// names in GDAL's other file systems ("/vsi..."). A refusal is stored.
  bool MayTouch(const char* path, bool create = false);
  bool MayUseNetwork(const char* name);
  bool MayUseSystem(const char* prefix, const char* name);

  /// True for archives, memory and parts of files, by their prefix. The files that they read in
  /// turn are judged separately.
  static bool IsHarmless(const std::string& prefix);

  /// True while GDAL reads from the network, for which it reads certificates and passwords of its
  /// own.
  bool Suspended = false;

private:
  static GDALDataset* Gate(GDALDriver* driver, GDALOpenInfo* info);
  static void HookFirstDriver();
  GDALDataset* OpenNested(GDALOpenInfo* info);
  bool MayOpen(const std::string& name);
  bool MayRead(const std::string& path);
  void Refuse(const std::string& reason);
  bool SpellsOut(const std::string& path) const;
  void AddFolder(const std::string& folder);
  void AddFolderOf(const std::string& path);
  bool IsBelow(const std::string& path) const;

  std::string File;
  SourcePolicy Policy;
  std::vector<std::string> DriverNames;
  CPLStringList Drivers;
  std::vector<std::string> Folders; ///< without links, each ending in /
  std::string Refusal;
  std::string Passing; ///< the name for which the drivers were already chosen
  SourceGuard* Outer = nullptr;
  // Everything must happen in this thread, because threads of GDAL have no guard.
  CPLConfigOptionSetter OneThread{ "GDAL_NUM_THREADS", "1", false };
  CPLConfigOptionSetter OneVirtualThread{ "VRT_NUM_THREADS", "1", false };
  // Reading from a server that stops answering is given up.
  CPLConfigOptionSetter ConnectTime{ "GDAL_HTTP_CONNECTTIMEOUT", "20", true };
  CPLConfigOptionSetter SilentTime{ "GDAL_HTTP_LOW_SPEED_TIME", "20", true };
  CPLConfigOptionSetter SilentBytes{ "GDAL_HTTP_LOW_SPEED_LIMIT", "1", true };
};

} // namespace skyline

#endif
