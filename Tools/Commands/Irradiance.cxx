// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Files.h"
#include "LightOptions.h"
#include "Lights.h"
#include "Options.h"
#include "Shared/Constants.h"
#include "Values.h"

#include "vtkHeightFieldIrradiance.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSkylineLight.h"

#include <cstdio>
#include <map>
#include <memory>
#include <string>

namespace
{

const std::map<std::string, int> Quadratures{ { "constant", vtkHeightFieldIrradiance::CONSTANT },
  { "blend", vtkHeightFieldIrradiance::BLEND }, { "linear", vtkHeightFieldIrradiance::LINEAR } };

struct IrradianceCommand
{
  skyline::TerrainOptions Terrain;
  skyline::OutputOptions Output;
  skyline::HorizonOptions Horizon;
  skyline::LightDescription Lights;
  std::string Method = "table";
  std::string Quadrature = "constant";
  int Bands = 4;
  bool NoRefinement = false;
  bool Horizontal = false;
  skyline::CommonOptions Common;

  // The type of the sky; a uniform one if the user wants no light.
  skyline::SkyKind Kind() const
  {
    const bool others = this->Lights.Sun.Asked() || !this->Lights.Lamps.empty();
    return !this->Lights.Sky && others ? skyline::SkyKind::None : this->Lights.KindOfSky();
  }

  void Check(const skyline::UnusedOptions& options) const
  {
    using skyline::SkyKind;
    const SkyKind kind = this->Kind();
    const bool sun = this->Lights.Sun.Asked();
    const bool harmonics = this->Method == "sh";
    this->Horizon.RefuseUnused(options);
    skyline::RefuseUnusedLights(this->Lights, options, kind, sun, true);
    options.Refuse(harmonics, { "--quadrature", "--no-refinement" },
      "only the method table uses it; leave it out, or add --method table");
    options.Refuse(harmonics, { "--limb-darkening" },
      "the method sh blurs the sun too much to show it; leave it out, or add --method table");
    options.Refuse(
      !harmonics, { "--bands" }, "only the method sh uses them; leave it out, or add --method sh");
    options.Warn(harmonics && !sun && kind == SkyKind::Uniform, { "--bands" },
      "the first band represents a uniform sky completely", this->Common);
    const bool lampsAlone = kind == SkyKind::None && !sun;
    options.Refuse(lampsAlone && harmonics, { "--method" },
      "the method sh does not compute lamps; leave it out, or give a sky or a sun");
    options.Warn(
      lampsAlone, { "--horizon", "--tolerance" }, "lamps alone need no horizons", this->Common);
    const bool drawn = sun && this->Lights.Sun.Radius.value_or(0.0) > skyline::LargestSunRadius;
    options.Warn(lampsAlone || (!harmonics && kind == SkyKind::None && !drawn),
      { "--azimuths", "--quadrature", "--no-refinement" },
      "only a sky uses it; a sun or a lamp chooses its own azimuths", this->Common);
    options.Warn((kind == SkyKind::Uniform || kind == SkyKind::Zonal) && !drawn,
      { "--no-refinement" }, "this sky is equally bright all around and is not refined",
      this->Common);
  }

  void Run() const
  {
    skyline::PrepareVtk(this->Common);
    skyline::CheckRasterOutput(
      this->Output.File, { this->Terrain.File, this->Lights.Sky ? this->Lights.Sky->Text : "" });
    skyline::WarnOfZone(this->Lights.Sun, this->Common);
    if (this->Kind() == skyline::SkyKind::Formula && !this->Lights.Sun.Asked())
    {
      skyline::PrintWarning(skyline::Doubt{ "the sky " + this->Lights.Sky->Text +
                                " is brighter around the sun, and no sun is given",
                              "its sun at azimuth 315, elevation 45", "--sun AZ,EL" },
        this->Common);
    }
    skyline::WarnOfTurnedSky(this->Lights, this->Kind(), this->Common);
    const auto terrain = skyline::ReadTerrain(this->Terrain, this->Common, this->Output.File);
    this->Horizon.WarnUnused(terrain, this->Common);
    vtkNew<vtkHeightFieldIrradiance> light;
    light->SetInputData(terrain);
    light->SetNumberOfAzimuths(this->Horizon.Azimuths);
    this->Horizon.Apply(light.Get());
    light->SetLightMethod(
      this->Method == "sh" ? vtkHeightFieldIrradiance::HARMONICS : vtkHeightFieldIrradiance::TABLE);
    light->SetQuadrature(Quadratures.at(this->Quadrature));
    light->SetHarmonicBands(this->Bands);
    light->SetRefine(!this->NoRefinement);
    light->SetHorizontal(this->Horizontal);
    for (const auto& one : skyline::MakeLights(this->Lights, terrain, this->Common))
    {
      light->AddLight(one);
    }
    skyline::RunPass(light, "irradiance", this->Common);
    if (this->Common.Verbose)
    {
      std::fprintf(stderr, "%-14s %d azimuths, %d environment, %d sun, %d lamp passes\n", "",
        light->GetSearchedAzimuths(), light->GetEnvironmentPasses(), light->GetSunPasses(),
        light->GetLampPasses());
    }
    skyline::WriteRaster(light, { "Irradiance" }, this->Output, this->Common);
  }
};

} // namespace

namespace skyline
{

void AddIrradiance(CLI::App& program)
{
  CLI::App* app =
    program.add_subcommand("irradiance", "Compute the light that falls on every post");
  const auto command = std::make_shared<IrradianceCommand>();
  command->Horizon.Azimuths = 128;
  app->footer(
    "Writes a GeoTIFF of float32 with three bands, red, green and blue: the irradiance of the\n"
    "tilted surface at each post, in W/m2 if radiances are in W/m2/sr. All lights are added.\n"
    "Without lights, the sky is uniform with radiance 1, which gives open level ground the\n"
    "irradiance pi.");
  command->Terrain.AddTo(*app);
  command->Output.AddTo(*app, "GeoTIFF to write");
  skyline::AddLightOptions(*app, command->Lights);
  app
    ->add_option("--method", command->Method,
      "table: the light above the horizon of each azimuth is integrated exactly;\n"
      "sh: spherical harmonics, a fast preview that blurs suns")
    ->check(OneOf({ "table", "sh" }))
    ->type_name("NAME")
    ->capture_default_str();
  app->add_flag(
    "--horizontal", command->Horizontal, "Compute the irradiance of a level surface at each post");
  app
    ->add_option("--quadrature", command->Quadrature,
      "Method table: what is assumed between two azimuths.\n"
      "constant: each horizon holds in its whole swath;\n"
      "blend: light counts for both horizons, weighted by nearness;\n"
      "linear: horizons are linear between azimuths")
    ->check(OneOf({ "constant", "blend", "linear" }))
    ->type_name("NAME")
    ->capture_default_str();
  app->add_flag("--no-refinement", command->NoRefinement,
    "Method table: do not add azimuths where the environment is bright");
  AddWhole(*app, "--bands", command->Bands, 2, 8, "Method sh: number of bands, 2 to 8")
    ->type_name("N");
  HorizonNeeds needs;
  needs.Method = "--horizon";
  command->Horizon.AddTo(*app, needs);
  AddCommonOptions(*app, command->Common);
  RunAfterCheck(*app, command);
}

} // namespace skyline
