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
      "Posts of this value have no height, besides those that the file declares missing: any number\n"
      "as the file has it, before scale and unit; may be repeated")
    ->type_name("V")
    ->type_size(1)
    ->allow_extra_args(false)
    ->check(Checked(CheckNodata));
  this->Sources.AddTo(command);
}

void SourceOptions::AddTo(CLI::App& command)
{
  command.add_flag("--allow-network", this->AllowNetwork,
    "Let the DEM be on a server, or lead to one (URLs, /vsicurl/, /vsis3/ ...)");
  command.add_flag("--allow-elsewhere", this->AllowElsewhere,
    "Let the DEM lead to files outside its own folder, as a VRT over tiles in another folder does");
  command
    .add_option("--driver", this->Drivers,
      "Let this driver of GDAL (WMS, WCS ...) open the DEM too, beside those of local rasters;\n"
      "may be repeated")
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
      "Azimuths around every post, evenly spaced clockwise from grid north; 1 to 3600")
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
        ? "exact: every edge of the surface counts; fast: the same here;\n"
          "sweep: the recurrence of Lee & Kim, off by metres"
        : "exact: every edge of the surface counts;\nfast: up to 0.25 degrees lower than exact, by how much depends on the "
          "processor;\n"
          "sweep: line sweeps, resampled to the posts, off by degrees at places;\n"
          "pyramid: smoothed heights, for soft shadows; off by a degree, none below 0")
    ->check(OneOf(methods))
    ->type_name("NAME")
    ->capture_default_str();
  if (!needs.Heights)
  {
    command
      .add_option("--surface", this->Surface,
        "Surface through the posts. triangles: cells split from south-west to north-east;\n"
        "bilinear: bilinear cells, with methods exact and fast")
      ->check(OneOf({ "triangles", "bilinear" }))
      ->type_name("NAME")
      ->capture_default_str();
  }
  command.add_flag(
    "--flat", this->Flat, "Ignore the curvature of the body (a raster without CRS is flat anyway)");
  AddNumber(command, "--refraction", this->Refraction, RefractionLimits,
    "Terrestrial refraction, on the Earth alone: the Earth's radius over that of a light ray;\n"
    "-100 to below 1. Default: " +
      NumberText(TerrestrialRefraction))
    ->type_name("K");
  if (!needs.Heights)
  {
    AddNumber(command, "--tolerance", this->Tolerance, { "0 to 90 degrees", 0.0, 90.0 },
      "Degrees by which method exact may fall short of the horizon, for speed; 0 to 90.\n"
      "Above 0, what is found within them depends on the processor")
      ->type_name("DEG");
  }
}

void HorizonOptions::RefuseIdle(const UnusedOptions& options) const
{
  const bool triangles = this->Method == "sweep" || this->Method == "pyramid";
  options.Refuse(triangles && this->Surface != "triangles", { "--surface" },
    this->Surface + " is not a surface of " + this->Method +
      "; leave it out, or find horizons by " + this->MethodName + " exact or fast");
  options.Refuse(this->Method != "exact", { "--tolerance" },
    "only the method exact has one; leave it out, or find horizons by " + this->MethodName +
      " exact");
  options.Refuse(
    this->Flat, { "--refraction" }, "there is none with --flat; leave one of the two out");
}

void HorizonOptions::WarnIdle(vtkImageData* terrain, const CommonOptions& common) const
{
  const Georeference place = LoadGeoreference(terrain);
  if (this->Refraction && !(place.OnBody() && place.Earth))
  {
    const std::string where = place.OnBody() ? "the DEM lies on another body"
                                             : "the DEM has no CRS that places it on a body";
    PrintWarning(
      Doubt{ "--refraction acts on the Earth alone, and " + where, "no refraction", "" }, common);
  }
}

void AddCommonOptions(CLI::App& command, CommonOptions& common)
{
  AddWhole(command, "--threads", common.Threads, 0, MostThreads,
    "Threads; 0: one a processor. Results do not differ")
    ->type_name("N");
  command.add_flag("-q,--quiet", common.Quiet, "No progress bar and no warnings");
  command.add_flag("-v,--verbose", common.Verbose, "Print the passes that ran and their times");
}

} // namespace skyline
