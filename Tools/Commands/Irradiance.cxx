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
    this->Horizon.RefuseIdle(options);
    skyline::RefuseIdleLights(this->Lights, options, kind, sun, true);
    options.Refuse(harmonics, { "--quadrature", "--no-refinement" },
      "only the method table has it; leave it out, or add --method table");
    options.Refuse(harmonics, { "--limb-darkening" },
      "the method sh blurs the sun beyond it; leave it out, or add --method table");
    options.Refuse(
      !harmonics, { "--bands" }, "only the method sh has them; leave it out, or add --method sh");
    options.Warn(harmonics && !sun && kind == SkyKind::Uniform, { "--bands" },
      "all of a uniform sky lies in the first band", this->Common);
    const bool lampsAlone = kind == SkyKind::None && !sun;
    options.Refuse(lampsAlone && harmonics, { "--method" },
      "the method sh does not compute lamps; leave it out, or give a sky or a sun");
    options.Warn(
      lampsAlone, { "--horizon", "--tolerance" }, "lamps alone need no horizons", this->Common);
    const bool drawn = sun && this->Lights.Sun.Radius.value_or(0.0) > skyline::LargestSunRadius;
    options.Warn(lampsAlone || (!harmonics && kind == SkyKind::None && !drawn),
      { "--azimuths", "--quadrature", "--no-refinement" },
      "only a sky is spread over azimuths, a sun or a lamp has its own", this->Common);
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
    this->Horizon.WarnIdle(terrain, this->Common);
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
  CLI::App* app = program.add_subcommand("irradiance", "The light that falls on every post");
  const auto command = std::make_shared<IrradianceCommand>();
  command->Horizon.Azimuths = 128;
  app->footer(
    "Writes a GeoTIFF of float32 with three bands, red, green and blue: the irradiance of the "
    "tilted surface,\nW/m2 where radiance counts in W/m2/sr. Lights add up; without any, a uniform "
    "sky of radiance 1 shines,\nwhich gives open level ground pi.");
  command->Terrain.AddTo(*app);
  command->Output.AddTo(*app, "GeoTIFF to write");
  skyline::AddLightOptions(*app, command->Lights);
  app
    ->add_option("--method", command->Method,
      "table: light integrated exactly above the horizon of each azimuth;\n"
      "sh: spherical harmonics, a fast preview that blurs suns")
    ->check(OneOf({ "table", "sh" }))
    ->type_name("NAME")
    ->capture_default_str();
  app->add_flag("--horizontal", command->Horizontal, "Irradiance of a level plate at the post");
  app
    ->add_option("--quadrature", command->Quadrature,
      "Method table, between azimuths. constant: each horizon stands for its swath;\n"
      "blend: light is weighted between the two; linear: horizons are linear")
    ->check(OneOf({ "constant", "blend", "linear" }))
    ->type_name("NAME")
    ->capture_default_str();
  app->add_flag("--no-refinement", command->NoRefinement,
    "Method table: no further azimuths where the environment is bright");
  AddWhole(*app, "--bands", command->Bands, 2, 8, "Bands of method sh, 2 to 8")->type_name("N");
  HorizonNeeds needs;
  needs.Method = "--horizon";
  command->Horizon.AddTo(*app, needs);
  AddCommonOptions(*app, command->Common);
  RunAfterCheck(*app, command);
}

} // namespace skyline
