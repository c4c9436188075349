// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Data/ImageGeoreference.h"
#include "UnusedOptions.h"
#include "Values.h"

#include "vtkImageData.h"

#include <CLI/CLI.hpp>

#include <limits>
#include <vector>

namespace
{

constexpr int MostAzimuths = 3600;
constexpr int MostThreads = 4096;

// Near hot ground, k down to about -5 was measured. Far below -100 all terrain would disappear.
const skyline::Limits RefractionLimits{ "-100 to below 1, 0.13 in usual air", -100.0, 1.0, false,
  true };

std::string CheckNodata(const std::string& text)
{
  const bool special = text == "nan" || text == "inf" || text == "-inf";
  return special || skyline::ReadNumber(text) ? ""
                                              : skyline::NumbersError(text) +
      "; give the value of posts without a height, as in -9999 or nan";
}

} // namespace

namespace skyline
{

void TerrainOptions::AddTo(CLI::App& command)
{
  command.add_option("DEM", this->File, "Raster of heights in a common local format")
    ->required()
    ->type_name("");
  AddWhole(
    command, "--band", this->Band, 1, std::numeric_limits<int>::max(), "Band of the raster, from 1")
    ->type_name("N");
  command
    .add_option("--nodata", this->Nodata,
      "Value of missing posts, in addition to those that the file declares: any number, as it is\n"
      "stored in the file, before scale and unit; may be repeated")
    ->type_name("V")
    ->type_size(1)
    ->allow_extra_args(false)
    ->check(Checked(CheckNodata));
  this->Sources.AddTo(command);
}

void SourceOptions::AddTo(CLI::App& command)
{
  command.add_flag("--allow-network", this->AllowNetwork,
    "Allow a DEM that is on a server, or refers to one (URLs, /vsicurl/, /vsis3/ ...)");
  command.add_flag("--allow-elsewhere", this->AllowElsewhere,
    "Allow a DEM that refers to files outside its own folder, such as a VRT with tiles elsewhere");
  command
    .add_option("--driver", this->Drivers,
      "Allow this GDAL driver (WMS, WCS ...) to open the DEM, in addition to those of local\n"
      "rasters; may be repeated")
    ->type_name("NAME")
    ->type_size(1)
    ->allow_extra_args(false);
}

void OutputOptions::AddTo(CLI::App& command, const std::string& what, bool required)
{
  command.add_option("-o,--output", this->File, what)->required(required)->type_name("FILE");
  command.add_flag("--cloud-optimized", this->CloudOptimized,
    "Write a cloud-optimized GeoTIFF: tiled, with overviews");
}

void HorizonOptions::AddTo(CLI::App& command, const HorizonNeeds& needs)
{
  this->MethodName = needs.Method;
  if (needs.Azimuths)
  {
    AddWhole(command, "--azimuths", this->Azimuths, 1, MostAzimuths,
      "Number of azimuths around every post, evenly spaced clockwise from grid north; 1 to 3600")
      ->type_name("N");
  }
  std::vector<std::string> methods{ "exact", "fast", "sweep" };
  if (!needs.Heights)
  {
    methods.emplace_back("pyramid");
  }
  command
    .add_option(needs.Method, this->Method,
      needs.Heights
        ? "exact: every edge of the surface counts; fast: the same as exact here;\n"
          "sweep: the recurrence of Lee & Kim, with errors of metres"
        : "exact: every edge of the surface counts;\n"
          "fast: up to 0.25 degrees lower than exact; how much depends on the processor;\n"
          "sweep: line sweeps, resampled to the posts, with errors of degrees in places;\n"
          "pyramid: smoothed heights, for soft shadows; errors of a degree, no horizon below 0")
    ->check(OneOf(methods))
    ->type_name("NAME")
    ->capture_default_str();
  if (!needs.Heights)
  {
    command
      .add_option("--surface", this->Surface,
        "Surface between the posts. triangles: cells split from south-west to north-east;\n"
        "bilinear: bilinear cells, with the methods exact and fast only")
      ->check(OneOf({ "triangles", "bilinear" }))
      ->type_name("NAME")
      ->capture_default_str();
  }
  command.add_flag(
    "--flat", this->Flat, "Ignore curvature and refraction (always so for a raster without CRS)");
  AddNumber(command, "--refraction", this->Refraction, RefractionLimits,
    "Coefficient of terrestrial refraction, used on the Earth only: the radius of the Earth\n"
    "divided by that of a light ray; -100 to below 1. Default: " +
      NumberText(TerrestrialRefraction))
    ->type_name("K");
  if (!needs.Heights)
  {
    AddNumber(command, "--tolerance", this->Tolerance, { "0 to 90 degrees", 0.0, 90.0 },
      "Degrees by which a horizon of the method exact may be too low, for speed; 0 to 90. Above\n"
      "0, the result within the tolerance depends on the processor")
      ->type_name("DEG");
  }
}

void HorizonOptions::RefuseUnused(const UnusedOptions& options) const
{
  const bool triangles = this->Method == "sweep" || this->Method == "pyramid";
  options.Refuse(triangles && this->Surface != "triangles", { "--surface" },
    "the method " + this->Method + " supports triangles only; leave it out, or use " +
      this->MethodName + " exact or fast");
  options.Refuse(this->Method != "exact", { "--tolerance" },
    "only the method exact uses it; leave it out, or use " + this->MethodName + " exact");
  options.Refuse(
    this->Flat, { "--refraction" }, "--flat switches refraction off; leave one of the two out");
}

void HorizonOptions::WarnUnused(vtkImageData* terrain, const CommonOptions& common) const
{
  const Georeference place = LoadGeoreference(terrain);
  if (this->Refraction && !(place.OnBody() && place.Earth))
  {
    const std::string where = place.OnBody() ? "the DEM lies on another body"
                                             : "the DEM has no CRS that places it on a body";
    PrintWarning(
      Doubt{ "--refraction has an effect on the Earth only, and " + where, "no refraction", "" },
      common);
  }
}

void AddCommonOptions(CLI::App& command, CommonOptions& common)
{
  AddWhole(command, "--threads", common.Threads, 0, MostThreads,
    "Number of threads; 0: one per processor. The result does not depend on it")
    ->type_name("N");
  command.add_flag("-q,--quiet", common.Quiet, "Print no progress bar and no warnings");
  command.add_flag("-v,--verbose", common.Verbose, "Print the passes that ran and their times");
}

} // namespace skyline
