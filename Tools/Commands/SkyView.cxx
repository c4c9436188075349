// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Files.h"
#include "Options.h"
#include "Values.h"

#include "vtkHeightFieldSkyView.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace
{

const std::vector<std::string> UsualQuantities{ "SkyViewFactor", "SkyViewFactorHorizontal",
  "VisibleSkyFraction", "PositiveOpenness" };
const std::vector<std::string> AllQuantities{ "SkyViewFactor", "SkyViewFactorHorizontal",
  "VisibleSkyFraction", "PositiveOpenness", "EdgeTrust" };

struct SkyViewCommand
{
  skyline::TerrainOptions Terrain;
  skyline::OutputOptions Output;
  skyline::HorizonOptions Horizon;
  std::vector<std::string> Quantities;
  std::optional<double> EdgeDistance; // metres
  skyline::CommonOptions Common;

  void Check(const skyline::UnusedOptions& options) const
  {
    this->Horizon.RefuseIdle(options);
    const bool trust = std::find(this->Quantities.begin(), this->Quantities.end(), "EdgeTrust") !=
      this->Quantities.end();
    options.Refuse(!trust, { "--edge-distance" },
      "only the quantity EdgeTrust has it; leave it out, or add --quantity EdgeTrust");
  }

  void Run() const
  {
    skyline::PrepareVtk(this->Common);
    skyline::CheckRasterOutput(this->Output.File, { this->Terrain.File });

    // Each quantity once, in the order given by the user.
    std::vector<std::string> wanted;
    for (const std::string& name : this->Quantities.empty() ? UsualQuantities : this->Quantities)
    {
      if (std::find(wanted.begin(), wanted.end(), name) == wanted.end())
      {
        wanted.push_back(name);
      }
    }
    const auto asked = [&](const char* name)
    { return std::find(wanted.begin(), wanted.end(), name) != wanted.end(); };

    const auto terrain = skyline::ReadTerrain(this->Terrain, this->Common, this->Output.File);
    this->Horizon.WarnIdle(terrain, this->Common);
    vtkNew<vtkHeightFieldSkyView> sky;
    sky->SetInputData(terrain);
    sky->SetNumberOfAzimuths(this->Horizon.Azimuths);
    this->Horizon.Apply(sky.Get());
    sky->SetSkyViewFactor(asked("SkyViewFactor"));
    sky->SetSkyViewFactorHorizontal(asked("SkyViewFactorHorizontal"));
    sky->SetVisibleSkyFraction(asked("VisibleSkyFraction"));
    sky->SetPositiveOpenness(asked("PositiveOpenness"));
    sky->SetEdgeTrust(asked("EdgeTrust"));
    if (this->EdgeDistance)
    {
      sky->AutoEdgeDistanceOff();
      sky->SetEdgeDistance(*this->EdgeDistance);
    }
    skyline::RunPass(sky, "sky view", this->Common);

    skyline::WriteRaster(sky, wanted, this->Output, this->Common);
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
  app->footer(
    "Writes a GeoTIFF of float32, one band a quantity, described by its name:\n"
    "  SkyViewFactor            0 to 1: share of a uniform sky's light that falls on the "
    "tilted surface\n"
    "  SkyViewFactorHorizontal  0 to 1: the same on a level plate at the post\n"
    "  VisibleSkyFraction       0 to 1: share of the upper hemisphere's solid angle\n"
    "  PositiveOpenness         degrees, 0 to 180: mean zenith angle of the horizon\n"
    "  EdgeTrust                0 to 1: share of the azimuths in which the data reach at "
    "least --edge-distance\n"
    "Beyond the data nothing is known: where no terrain lies the horizon is -90, so posts "
    "near the rim see too\nmuch (openness of level ground: 90, at an edge 135, at a corner "
    "157.5). Keep those with EdgeTrust 1.");
  command->Terrain.AddTo(*app);
  command->Output.AddTo(*app, "GeoTIFF to write");
  app
    ->add_option("--quantity", command->Quantities,
      "A quantity to write, see below; may be repeated. Default: all but EdgeTrust")
    ->type_name("NAME")
    ->check(OneOf(AllQuantities))
    ->type_size(1)
    ->allow_extra_args(false);
  AddNumber(*app, "--edge-distance", command->EdgeDistance, { "0 to 1e9 metres", 0.0, 1e9 },
    "How far the data must reach for EdgeTrust, metres, 0 (any terrain at all) or more.\n"
    "Default: 1000, or a tenth of the DEM's shorter side if that is less")
    ->type_name("METRES");
  command->Horizon.AddTo(*app);
  AddCommonOptions(*app, command->Common);
  RunAfterCheck(*app, command);
}

} // namespace skyline
