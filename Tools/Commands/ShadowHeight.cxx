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
    this->Horizon.RefuseIdle(options);
    options.Refuse(!this->Soft, { "--sun-radius" },
      "the shadow of the sun's middle has none; add --soft, or leave it out");
    options.Warn(this->Soft && this->Sun.Radius == 0.0, { "--soft" },
      "both limbs of a sun with the radius 0 are its middle", this->Common);
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
    this->Horizon.WarnIdle(terrain, this->Common);
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
    program.add_subcommand("shadow-height", "How high the shadow of the terrain stands");
  const auto command = std::make_shared<ShadowHeightCommand>();
  app->footer(
    "Writes a GeoTIFF of float32 in metres. ShadowHeight: what lies lower above the post "
    "is in the shadow of the\nterrain; the post's own height where it is lit, nodata "
    "everywhere, with a warning, for a sun on or\nunder the horizontal plane. With --soft also ShadowHeightUpper and "
    "ShadowHeightLower, for the upper and lower limb of the disc: below the first all\nof "
    "the sun is hidden, above the second none; these may lie under the ground. One sun "
    "for the whole DEM:\nwith --time, that over its centre. ");
  command->Terrain.AddTo(*app);
  command->Output.AddTo(*app, "GeoTIFF to write");
  AddSunOptions(*app, command->Sun, false);
  app->add_flag("--soft", command->Soft, "Add the shadow heights of the limbs of the sun's disc");
  HorizonNeeds needs;
  needs.Azimuths = false;
  needs.Heights = true;
  command->Horizon.AddTo(*app, needs);
  AddCommonOptions(*app, command->Common);
  RunAfterCheck(*app, command);
}

} // namespace skyline
