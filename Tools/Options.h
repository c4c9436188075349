// SPDX-License-Identifier: BSD-3-Clause
// The options that commands share, in groups: a command adds the groups it uses.
#ifndef skyline_Options_h
#define skyline_Options_h

#include "Constants.h"
#include "Passes.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace skyline
{

/// --allow-network, --allow-elsewhere, --driver: what a file may lead to.
struct SourceOptions
{
  bool AllowNetwork = false;
  bool AllowElsewhere = false;
  std::vector<std::string> Drivers;
  void AddTo(CLI::App& command);

  template <typename Reader>
  void Apply(Reader* reader) const
  {
    reader->SetAllowNetwork(this->AllowNetwork);
    reader->SetAllowElsewhere(this->AllowElsewhere);
    for (const std::string& name : this->Drivers)
    {
      reader->AddDriver(name.c_str());
    }
  }
};

/// DEM, --band, --nodata, and the options of sources: what is read.
struct TerrainOptions
{
  std::string File;
  int Band = 1;
  std::vector<double> Nodata; ///< besides the file's own
  SourceOptions Sources;
  void AddTo(CLI::App& command);
};

/// -o, --cloud-optimized: what is written.
struct OutputOptions
{
  std::string File;
  bool CloudOptimized = false;
  void AddTo(CLI::App& command, const std::string& what, bool required = true);
};

/// --azimuths, --method, --surface, --flat, --refraction, --tolerance: how horizons are found.
struct HorizonOptions
{
  int Azimuths = 36;
  std::string Method = "exact";
  std::string Surface = "triangles";
  bool Flat = false;
  double Refraction = TerrestrialRefraction;
  double Tolerance = 0.0;
  void AddTo(CLI::App& command, bool azimuths = true, const char* method = "--method");

  /// Sets the properties that all filters of horizons share. Throws Failure for values out of
  /// range.
  template <typename Filter>
  void Apply(Filter* filter) const
  {
    this->Check();
    filter->SetMethod(this->Method == "exact" ? Filter::EXACT
        : this->Method == "fast"              ? Filter::FAST
        : this->Method == "sweep"             ? Filter::SWEEP
                                              : Filter::PYRAMID);
    filter->SetSurface(this->Surface == "triangles" ? Filter::TRIANGLES : Filter::BILINEAR);
    filter->SetFlat(this->Flat);
    filter->SetRefractionCoefficient(this->Refraction);
    filter->SetTolerance(this->Tolerance);
  }

private:
  void Check() const; // the filters clamp
};

/// --quiet, --verbose, --threads.
void AddTalk(CLI::App& command, Talk& talk);

} // namespace skyline

#endif
