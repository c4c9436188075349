// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Files.h"
#include "Options.h"

#include "vtkHeightFieldSkyView.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace
{

const std::vector<std::string> AllQuantities{ "SkyViewFactor", "SkyViewFactorHorizontal",
  "VisibleSkyFraction", "PositiveOpenness" };

struct SkyViewCommand
{
  skyline::TerrainOptions Terrain;
  skyline::OutputOptions Output;
  skyline::HorizonOptions Horizon;
  std::vector<std::string> Quantities;
  skyline::Talk Talk;

  void Run() const
  {
    skyline::PrepareVtk(this->Talk);
    skyline::CheckOutput(this->Output.File, { this->Terrain.File });

    // Every quantity once, in the order asked for.
    std::vector<std::string> wanted;
    for (const std::string& name : this->Quantities.empty() ? AllQuantities : this->Quantities)
    {
      if (std::find(wanted.begin(), wanted.end(), name) == wanted.end())
      {
        wanted.push_back(name);
      }
    }
    const auto asked = [&](const char* name)
    { return std::find(wanted.begin(), wanted.end(), name) != wanted.end(); };

    const auto terrain = skyline::ReadTerrain(this->Terrain, this->Talk, this->Output.File);
    vtkNew<vtkHeightFieldSkyView> sky;
    sky->SetInputData(terrain);
    sky->SetNumberOfAzimuths(this->Horizon.Azimuths);
    this->Horizon.Apply(sky.Get());
    sky->SetSkyViewFactor(asked("SkyViewFactor"));
    sky->SetSkyViewFactorHorizontal(asked("SkyViewFactorHorizontal"));
    sky->SetVisibleSkyFraction(asked("VisibleSkyFraction"));
    sky->SetPositiveOpenness(asked("PositiveOpenness"));
    skyline::RunPass(sky, "sky view", this->Talk);

    skyline::WriteRaster(sky, wanted, this->Output, this->Talk);
  }
};

} // namespace

namespace skyline
{

void AddSkyView(CLI::App& program)
{
  CLI::App* app = program.add_subcommand("sky-view", "How much of the sky every post sees");
  const auto command = std::make_shared<SkyViewCommand>();
  command->Horizon.Azimuths = 72;
  app->footer("Writes a GeoTIFF of float32, one band a quantity, described by its name:\n"
              "  SkyViewFactor            0 to 1: share of a uniform sky's light that falls on the "
              "tilted surface\n"
              "  SkyViewFactorHorizontal  0 to 1: the same on a level plate at the post\n"
              "  VisibleSkyFraction       0 to 1: share of the upper hemisphere's solid angle\n"
              "  PositiveOpenness         degrees, 0 to 180: mean zenith angle of the horizon");
  command->Terrain.AddTo(*app);
  command->Output.AddTo(*app, "GeoTIFF to write");
  app
    ->add_option("--quantity", command->Quantities,
      "A quantity to write, see below; may be repeated. Default: all four")
    ->type_name("NAME")
    ->check(CLI::IsMember(AllQuantities))
    ->type_size(1)
    ->allow_extra_args(false);
  command->Horizon.AddTo(*app);
  AddTalk(*app, command->Talk);
  app->callback([command] { command->Run(); });
}

} // namespace skyline
