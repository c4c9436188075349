// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Files.h"
#include "LightOptions.h"
#include "Options.h"
#include "SunLight.h"

#include "vtkHeightFieldShadowHeight.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <memory>
#include <string>
#include <vector>

namespace
{

struct ShadowHeightCommand
{
  skyline::TerrainOptions Terrain;
  skyline::OutputOptions Output;
  skyline::HorizonOptions Horizon;
  skyline::SunDescription Sun;
  bool Soft = false;
  skyline::CommonOptions Common;

  void Check(const skyline::UnusedOptions& options) const
  {
    this->Horizon.RefuseUnused(options);
    options.Refuse(!this->Soft, { "--sun-radius" },
      "without --soft, only the centre of the sun counts; add --soft, or leave it out");
    options.Warn(this->Soft && this->Sun.Radius == 0.0, { "--soft" },
      "both limbs of a sun with the radius 0 lie in its middle", this->Common);
  }

  void Run() const
  {
    skyline::PrepareVtk(this->Common);
    skyline::CheckRasterOutput(this->Output.File, { this->Terrain.File });
    skyline::WarnOfZone(this->Sun, this->Common);
    if (this->Horizon.Method == "fast")
    {
      skyline::PrintWarning(
        skyline::Doubt{ "no method finds shadow heights faster than exact", "--method exact", "" },
        this->Common);
    }
    const auto terrain = skyline::ReadTerrain(this->Terrain, this->Common, this->Output.File);
    this->Horizon.WarnUnused(terrain, this->Common);
    const skyline::Center center = skyline::CenterOf(terrain, this->Common);
    const skyline::SunLight sun = skyline::FindSun(this->Sun, center.Place, center.Height);
    vtkNew<vtkHeightFieldShadowHeight> shadow;
    shadow->SetInputData(terrain);
    this->Horizon.Apply(shadow.Get());
    skyline::ApplySun(this->Sun, sun, shadow->GetSun());
    shadow->UseTimeOff(); // uses the sun over the centre, as the command prints it
    shadow->SetSoft(this->Soft);
    skyline::RunPass(shadow, "shadow height", this->Common);
    std::vector<std::string> bands{ "ShadowHeight" };
    if (this->Soft)
    {
      bands.insert(bands.end(), { "ShadowHeightUpper", "ShadowHeightLower" });
    }
    skyline::WriteRaster(shadow, bands, this->Output, this->Common);
  }
};

} // namespace

namespace skyline
{

void AddShadowHeight(CLI::App& program)
{
  CLI::App* app =
    program.add_subcommand("shadow-height", "Compute how high the shadow of the terrain reaches");
  const auto command = std::make_shared<ShadowHeightCommand>();
  app->footer(
    "Writes a GeoTIFF of float32 in metres with the band ShadowHeight: the height up to which the\n"
    "shadow of the terrain reaches over each post, in the height system of the DEM. Where the\n"
    "post is lit, the value is the height of the post. If the sun is on or below the horizontal\n"
    "plane, all posts are nodata, and a warning is printed. With --soft, the bands\n"
    "ShadowHeightUpper and ShadowHeightLower are added, for the upper and the lower limb of the\n"
    "disc: below the first, the whole sun is hidden; above the second, nothing of it is hidden.\n"
    "Both may lie below the ground. All posts have the same sun; with --time, it is the sun over\n"
    "the centre of the DEM.");
  command->Terrain.AddTo(*app);
  command->Output.AddTo(*app, "GeoTIFF to write");
  AddSunOptions(*app, command->Sun, false);
  app->add_flag("--soft", command->Soft,
    "Add the shadow heights for the upper and the lower limb of the sun's disc");
  HorizonNeeds needs;
  needs.Azimuths = false;
  needs.Heights = true;
  command->Horizon.AddTo(*app, needs);
  AddCommonOptions(*app, command->Common);
  RunAfterCheck(*app, command);
}

} // namespace skyline
