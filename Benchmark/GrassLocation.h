// SPDX-License-Identifier: BSD-3-Clause
// A temporary GRASS database, in which modules of GRASS are run as programs.
#ifndef skyline_GrassLocation_h
#define skyline_GrassLocation_h

#include "External.h"
#include "Reference/Oracle.h"

#include <filesystem>
#include <string>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// One location with a transverse Mercator projection of a sphere and the data around its origin,
/// where grid north differs from north by less than 1e-3 degrees. The destructor removes its
/// folder.
class GrassLocation
{
public:
  /// `base`: the folder that `grass --config path` prints. Sets environment variables of this
  /// process for GRASS.
  GrassLocation(const oracle::OracleField& field, const std::string& base);
  GrassLocation(const GrassLocation&) = delete;
  GrassLocation& operator=(const GrassLocation&) = delete;

  /// Runs a module without showing its output. Throws std::runtime_error if it fails.
  Cost Run(const std::string& module, std::vector<std::string> arguments) const;

  /// Creates a raster from the values of all posts, row by row from the south. Values that are not
  /// finite are missing.
  void Import(const std::string& raster, const std::vector<double>& values) const;

  /// Reads the only raster whose name starts with `prefix`, row by row from the north, and deletes
  /// it. Missing posts are Null.
  std::vector<float> Take(const std::string& prefix) const;

  static constexpr float Null = NoHeight;

private:
  std::string File(const char* name) const { return this->Folder.File(name); }
  std::filesystem::path Mapset() const { return this->Folder.Path() / "place" / "PERMANENT"; }
  double North() const; // the northern edge of the raster, half a spacing beyond its posts
  double East() const;

  const oracle::OracleField& Field;
  std::string Base;
  ScratchFolder Folder;
};

} // namespace benchmark
} // namespace skyline

#endif
