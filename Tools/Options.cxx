// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Failure.h"

namespace skyline
{

void TerrainOptions::AddTo(CLI::App& command)
{
  command.add_option("DEM", this->File, "Raster of heights: any file that GDAL opens")
    ->required()
    ->type_name("");
  command.add_option("--band", this->Band, "Band of the raster, from 1")
    ->type_name("N")
    ->capture_default_str();
  command
    .add_option("--nodata", this->Nodata,
      "Posts of this value have no height, besides those that the file declares missing: any number\n"
      "as the file has it, before scale and unit; may be repeated")
    ->type_name("V")
    ->type_size(1)
    ->allow_extra_args(false);
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

void HorizonOptions::AddTo(CLI::App& command, bool azimuths, const char* method)
{
  if (azimuths)
  {
    command
      .add_option("--azimuths", this->Azimuths,
        "Azimuths around every post, evenly spaced clockwise from grid north; 1 to 3600")
      ->type_name("N")
      ->capture_default_str();
  }
  command
    .add_option(method, this->Method,
      "exact: every edge of the surface counts;\nfast: up to 0.25 degrees lower than exact;\n"
      "sweep: line sweeps, resampled to the posts, off by degrees at places;\n"
      "pyramid: smoothed heights, for soft shadows; off by a degree, none below 0")
    ->check(CLI::IsMember({ "exact", "fast", "sweep", "pyramid" }))
    ->type_name("NAME")
    ->capture_default_str();
  command
    .add_option("--surface", this->Surface,
      "Surface through the posts. triangles: cells split from south-west to north-east;\n"
      "bilinear: bilinear cells; not with methods sweep and pyramid")
    ->check(CLI::IsMember({ "triangles", "bilinear" }))
    ->type_name("NAME")
    ->capture_default_str();
  command.add_flag(
    "--flat", this->Flat, "Ignore the curvature of the body (a raster without CRS is flat anyway)");
  command
    .add_option("--refraction", this->Refraction,
      "Terrestrial refraction, on the Earth alone: the Earth's radius over that of a light ray;\n"
      "below 1")
    ->type_name("K")
    ->capture_default_str();
  command
    .add_option("--tolerance", this->Tolerance,
      "Degrees by which method exact may fall short of the horizon, for speed; 0 to 90")
    ->type_name("DEG")
    ->capture_default_str();
}

void HorizonOptions::Check() const
{
  if (!(this->Tolerance >= 0.0 && this->Tolerance <= 90.0))
  {
    throw Failure("the tolerance is out of range; give 0 to 90 degrees");
  }
}

void AddTalk(CLI::App& command, Talk& talk)
{
  command
    .add_option("--threads", talk.Threads, "Threads; 0: one a processor. Results do not differ")
    ->type_name("N")
    ->check(CLI::Range(0, 4096))
    ->capture_default_str();
  command.add_flag("-q,--quiet", talk.Quiet, "No progress bar and no warnings");
  command.add_flag("-v,--verbose", talk.Verbose, "Print the passes that ran and their times");
}

} // namespace skyline
