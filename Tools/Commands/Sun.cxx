// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Failure.h"
#include "Files.h"
#include "LightOptions.h"
#include "Options.h"
#include "Sun/Eclipse.h"
#include "Sun/UtcTime.h"
#include "SunLight.h"

#include "Data/ImageGeoreference.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <cstdio>
#include <memory>
#include <string>

namespace
{

struct SunCommand
{
  skyline::TerrainOptions Terrain;
  skyline::OutputOptions Output;
  skyline::HorizonOptions Horizon;
  skyline::SunDescription Sun;
  skyline::CommonOptions Common;

  // Prints the sun at the centre of the DEM: one `name: value unit` per line, with fixed names.
  void Print() const
  {
    const skyline::Center center = skyline::ReadCenter(this->Terrain, this->Common);
    const skyline::SunLight sun = skyline::FindSun(this->Sun, center.Place, center.Height);
    const auto degrees = [](const char* name, double value)
    { std::printf("%s: %.5f degree\n", name, value); };
    degrees("azimuth", sun.TrueNorth ? sun.TrueAzimuth : sun.GridAzimuth);
    degrees("elevation", sun.Elevation);
    degrees("refracted elevation", sun.ApparentElevation);
    degrees("angular radius", sun.Radius);
    degrees("grid azimuth", sun.GridAzimuth);
    if (sun.TrueNorth)
    {
      degrees("longitude", center.Longitude);
      degrees("latitude", center.Latitude);
    }
    std::printf("height: %.2f metre\n", center.Height);
    if (sun.FromTime)
    {
      std::printf("time: %s UTC\n", skyline::ToText(skyline::ParseUtcTime(this->Sun.Time)).c_str());
      this->PrintEclipse(center, sun);
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
    {
      throw skyline::Failure("cannot write to standard output");
    }
  }

  // Prints two lines if the Moon covers a part of the sun and the sun has not set.
  void PrintEclipse(const skyline::Center& center, const skyline::SunLight& sun) const
  {
    const skyline::SunAndMoon seen =
      skyline::EclipseEphemeris(skyline::ParseUtcTime(this->Sun.Time))
        .At(center.Longitude, center.Latitude, center.Height);
    if (seen.Magnitude() > 0.0 && sun.ApparentElevation + sun.Radius > 0.0)
    {
      std::printf("eclipse obscuration: %.2f percent\n", 100.0 * seen.Obscuration());
      std::printf("eclipse magnitude: %.4f diameter\n", seen.Magnitude());
    }
  }

  void Write() const
  {
    skyline::CheckRasterOutput(this->Output.File, { this->Terrain.File });
    const auto terrain = skyline::ReadTerrain(this->Terrain, this->Common, this->Output.File);
    this->Horizon.WarnUnused(terrain, this->Common);
    vtkNew<vtkHeightFieldSunShadow> shadow;
    shadow->SetInputData(terrain);
    this->Horizon.Apply(shadow.Get());
    const skyline::Center center = skyline::CenterOf(terrain, this->Common);
    const skyline::SunLight sun = skyline::FindSun(this->Sun, center.Place, center.Height);
    skyline::ApplySun(this->Sun, sun, shadow->GetSun());
    skyline::RunPass(shadow, "sun", this->Common);
    skyline::WriteRaster(shadow, { "SunVisibility" }, this->Output, this->Common);
  }

  void Check(const skyline::UnusedOptions& options) const
  {
    this->Horizon.RefuseUnused(options);
    skyline::RefuseUnusedSun(this->Sun, options);
    options.Refuse(this->Output.File.empty(),
      { "--cloud-optimized", "--limb-darkening", "--method", "--surface", "--flat", "--refraction",
        "--tolerance" },
      "without -o no shadow is computed; add -o FILE, or leave it out");
  }

  void Run() const
  {
    skyline::PrepareVtk(this->Common);
    skyline::WarnOfZone(this->Sun, this->Common);
    if (this->Output.File.empty())
    {
      this->Print();
    }
    else
    {
      this->Write();
    }
  }
};

} // namespace

namespace skyline
{

void AddSun(CLI::App& program)
{
  CLI::App* app = program.add_subcommand(
    "sun", "Print the position of the sun, or compute which posts it lights");
  const auto command = std::make_shared<SunCommand>();
  app->footer(
    "Without -o, prints the sun at the centre of the DEM, one `name: value unit` per line:\n"
    "azimuth (clockwise from true north; from grid north for a DEM without CRS), elevation\n"
    "(without refraction), refracted elevation, angular radius, grid azimuth, and the place and\n"
    "time. During an eclipse of the sun at --time, also prints the eclipse obscuration (percent\n"
    "of the area of the disc that the Moon covers) and the eclipse magnitude (part of the\n"
    "diameter).\n"
    "With -o, writes a GeoTIFF of float32 with one band, SunVisibility: the visible share of the\n"
    "sun's disc, 0 to 1; during an eclipse at --time, multiplied by the share of its light that\n"
    "the Moon leaves.");
  command->Terrain.AddTo(*app);
  command->Output.AddTo(
    *app, "GeoTIFF to write. Default: none; the position of the sun is printed", false);
  AddSunOptions(*app, command->Sun);
  HorizonNeeds needs;
  needs.Azimuths = false;
  command->Horizon.AddTo(*app, needs);
  AddCommonOptions(*app, command->Common);
  RunAfterCheck(*app, command);
}

} // namespace skyline
