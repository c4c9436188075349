// SPDX-License-Identifier: BSD-3-Clause
// The options that commands share, in groups. A command adds the groups that it uses.
#ifndef skyline_Options_h
#define skyline_Options_h

#include "RunPass.h"
#include "Shared/Constants.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace CLI
{
class App;
}

namespace skyline
{

class UnusedOptions;

/// --allow-network, --allow-elsewhere, --driver: what a file may refer to.
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

/// DEM, --band, --nodata, and the options for sources: what is read.
struct TerrainOptions
{
  std::string File;
  int Band = 1;
  std::vector<double> Nodata; ///< besides that of the file
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

/// Which options on horizons a command has.
struct HorizonNeeds
{
  bool Azimuths = true; ///< --azimuths
  bool Heights = false; ///< shadow heights: no pyramid, no other surface, no tolerance
  const char* Method = "--method";
};

/// --azimuths, --method, --surface, --flat, --refraction, --tolerance: how horizons are found.
struct HorizonOptions
{
  int Azimuths = 36;
  std::string Method = "exact";
  std::string Surface = "triangles";
  bool Flat = false;
  std::optional<double> Refraction; ///< empty: TerrestrialRefraction
  double Tolerance = 0.0;
  void AddTo(CLI::App& command, const HorizonNeeds& needs = {});

  /// Throws WrongUsage for options that have no effect. To be called before any work.
  void RefuseUnused(const UnusedOptions& options) const;

  /// Warns of options that have no effect on this terrain.
  void WarnUnused(vtkImageData* terrain, const CommonOptions& common) const;

  /// Sets the properties that all filters on horizons share.
  template <typename Filter>
  void Apply(Filter* filter) const
  {
    filter->SetMethod(this->Method == "exact" ? Filter::EXACT
        : this->Method == "fast"              ? Filter::FAST
        : this->Method == "sweep"             ? Filter::SWEEP
                                              : Filter::PYRAMID);
    filter->SetSurface(this->Surface == "triangles" ? Filter::TRIANGLES : Filter::BILINEAR);
    filter->SetFlat(this->Flat);
    filter->SetRefractionCoefficient(this->Refraction.value_or(TerrestrialRefraction));
    filter->SetTolerance(this->Tolerance);
  }

private:
  std::string MethodName = "--method";
};

/// --quiet, --verbose, --threads.
void AddCommonOptions(CLI::App& command, CommonOptions& common);

} // namespace skyline

#endif
