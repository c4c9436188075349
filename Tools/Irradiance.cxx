// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Failure.h"
#include "Files.h"
#include "Lights.h"
#include "Options.h"

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
  skyline::LightOptions Lights;
  std::string Method = "table";
  std::string Quadrature = "constant";
  int Bands = 4;
  bool NoRefinement = false;
  bool Horizontal = false;
  skyline::Talk Talk;

  void Run() const
  {
    skyline::PrepareVtk(this->Talk);
    skyline::CheckOutput(this->Output.File, { this->Terrain.File, this->Lights.Environment });
    const auto terrain = skyline::ReadTerrain(this->Terrain, this->Talk, this->Output.File);
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
    for (const auto& one : skyline::MakeLights(this->Lights, terrain, this->Talk))
    {
      light->AddLight(one);
    }
    skyline::RunPass(light, "irradiance", this->Talk);
    if (this->Talk.Verbose)
    {
      std::fprintf(stderr, "%-14s %d azimuths, %d environment, %d sun, %d lamp passes\n", "",
        light->GetSearchedAzimuths(), light->GetEnvironmentPasses(), light->GetSunPasses(),
        light->GetLampPasses());
    }
    skyline::WriteRaster(light, { "Irradiance" }, this->Output, this->Talk);
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
  command->Lights.AddTo(*app);
  app
    ->add_option("--method", command->Method,
      "table: light integrated exactly above the horizon of each azimuth;\n"
      "sh: spherical harmonics, a fast preview that blurs suns")
    ->check(CLI::IsMember({ "table", "sh" }))
    ->type_name("NAME")
    ->capture_default_str();
  app->add_flag("--horizontal", command->Horizontal, "Irradiance of a level plate at the post");
  app
    ->add_option("--quadrature", command->Quadrature,
      "Method table, between azimuths. constant: each horizon stands for its swath;\n"
      "blend: light is weighted between the two; linear: horizons are linear")
    ->check(CLI::IsMember({ "constant", "blend", "linear" }))
    ->type_name("NAME")
    ->capture_default_str();
  app->add_flag("--no-refinement", command->NoRefinement,
    "Method table: no further azimuths where the environment is bright");
  app->add_option("--bands", command->Bands, "Bands of method sh, 2 to 8")
    ->check(CLI::Range(2, 8))
    ->type_name("N")
    ->capture_default_str();
  command->Horizon.AddTo(*app, true, "--horizon");
  AddTalk(*app, command->Talk);
  app->callback([command] { command->Run(); });
}

} // namespace skyline
