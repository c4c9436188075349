// SPDX-License-Identifier: BSD-3-Clause
// A temporary GRASS database, and the modules of GRASS run in it as programs.
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

/// One location on a sphere's transverse Mercator with the data about its origin: there grid north
/// is north to 1e-3 degrees. Its folder goes with it.
class GrassLocation
{
public:
  /// base: what `grass --config path` prints. Sets the process's environment for GRASS.
  GrassLocation(const oracle::OracleField& field, const std::string& base);
  GrassLocation(const GrassLocation&) = delete;
  GrassLocation& operator=(const GrassLocation&) = delete;

  /// Runs a module, silent; std::runtime_error if it fails.
  Cost Run(const std::string& module, std::vector<std::string> arguments) const;

  /// Values of all posts, row by row from the south, become a raster; not finite ones are missing.
  void Import(const std::string& raster, const std::vector<double>& values) const;

  /// The only raster whose name starts so, row by row from the north; missing posts are Null. The
  /// raster is forgotten.
  std::vector<float> Take(const std::string& prefix) const;

  static constexpr float Null = NoHeight;

private:
  std::string File(const char* name) const { return this->Folder.File(name); }
  std::filesystem::path Mapset() const { return this->Folder.Path() / "place" / "PERMANENT"; }
  double North() const; // edges of the raster, half a spacing beyond its posts
  double East() const;

  const oracle::OracleField& Field;
  std::string Base;
  ScratchFolder Folder;
};

} // namespace benchmark
} // namespace skyline

#endif
