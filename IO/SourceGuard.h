// SPDX-License-Identifier: BSD-3-Clause
// Keeps GDAL, while one file is read, from what the file's maker chose and its reader did not.
#ifndef skyline_SourceGuard_h
#define skyline_SourceGuard_h

#include "SourcePolicy.h"

#include <cpl_conv.h>
#include <gdal_priv.h>

#include <string>
#include <vector>

namespace skyline
{

/// While one lives, whatever GDAL opens in this thread is held to a policy, in every depth: the
/// sources of a virtual raster, masks, overviews, files named inside of other formats. Other
/// threads are not concerned. It lives and dies in one thread, the last one first.
class SourceGuard
{
public:
  /// `file`: the name that was asked for. Any file that this name spells out is asked for too, and so
  /// are those in its folder and below. `folder`: a further folder, or empty. Throws IoFailure for an
  /// unknown driver.
  SourceGuard(const std::string& file, const SourcePolicy& policy, const std::string& folder = "");
  ~SourceGuard();
  SourceGuard(const SourceGuard&) = delete;
  SourceGuard& operator=(const SourceGuard&) = delete;

  /// Opens a raster for reading by the drivers of the policy; null if that fails.
  GDALDataset* Open(const std::string& name);

  /// What was refused first, as the part of a sentence that follows the file's name, with the option
  /// that allows it; empty: nothing.
  const std::string& GetRefusal() const { return this->Refusal; }

  /// The refusal if `name` can only be opened by a driver outside the policy, else empty.
  std::string DriverRefusal(const std::string& name);

  /// The guard of this thread; null: none.
  static SourceGuard* GetCurrent();

  /// Whether a file on a local disk may be touched, and the like for names of GDAL's other file
  /// systems ("/vsi..."). Remembers a refusal.
  bool MayTouch(const char* path, bool create = false);
  bool MayUseNetwork(const char* name);
  bool MayUseSystem(const char* prefix, const char* name);

  /// Archives, memory and parts of files, by their prefix: what they read in turn is judged by itself.
  static bool IsHarmless(const std::string& prefix);

  /// True while GDAL fetches from the network, which reads certificates and passwords of its own.
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
  std::vector<std::string> Folders; ///< without links, ending in /
  std::string Refusal;
  std::string Passing; ///< the name whose drivers were already chosen
  SourceGuard* Outer = nullptr;
  // In this thread alone. Decoding in GDAL's own threads would be out of our hearing.
  CPLConfigOptionSetter OneThread{ "GDAL_NUM_THREADS", "1", false };
  CPLConfigOptionSetter OneVirtualThread{ "VRT_NUM_THREADS", "1", false };
  // A server that falls silent is given up.
  CPLConfigOptionSetter ConnectTime{ "GDAL_HTTP_CONNECTTIMEOUT", "20", true };
  CPLConfigOptionSetter SilentTime{ "GDAL_HTTP_LOW_SPEED_TIME", "20", true };
  CPLConfigOptionSetter SilentBytes{ "GDAL_HTTP_LOW_SPEED_LIMIT", "1", true };
};

} // namespace skyline

#endif
