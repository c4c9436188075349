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
    this->Horizon.RefuseUnused(options);
    const bool trust = std::find(this->Quantities.begin(), this->Quantities.end(), "EdgeTrust") !=
      this->Quantities.end();
    options.Refuse(!trust, { "--edge-distance" },
      "only the quantity EdgeTrust uses it; leave it out, or add --quantity EdgeTrust");
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
    this->Horizon.WarnUnused(terrain, this->Common);
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
  CLI::App* app = program.add_subcommand("sky-view", "Compute how much of the sky every post sees");
  const auto command = std::make_shared<SkyViewCommand>();
  command->Horizon.Azimuths = 72;
  app->footer(
    "Writes a GeoTIFF of float32 with one band per quantity; its name is the band description:\n"
    "  SkyViewFactor            0 to 1: share of the light of a uniform sky that falls on the\n"
    "                           tilted surface at the post\n"
    "  SkyViewFactorHorizontal  0 to 1: the same for a level surface at the post\n"
    "  VisibleSkyFraction       0 to 1: visible share of the solid angle of the upper hemisphere\n"
    "  PositiveOpenness         degrees, 0 to 180: mean zenith angle of the horizon\n"
    "  EdgeTrust                0 to 1: share of the azimuths in which the data reach at\n"
    "                           least as far as --edge-distance\n"
    "Nothing is known beyond the edge of the data: where no terrain lies in a direction, the\n"
    "horizon is -90 degrees. Posts near the edge therefore see too much sky (on level ground, the\n"
    "openness is 90, but 135 at an edge and 157.5 at a corner). Use only posts with EdgeTrust 1.");
  command->Terrain.AddTo(*app);
  command->Output.AddTo(*app, "GeoTIFF to write");
  app
    ->add_option("--quantity", command->Quantities,
      "Quantity to write, see below; may be repeated. Default: all except EdgeTrust")
    ->type_name("NAME")
    ->check(OneOf(AllQuantities))
    ->type_size(1)
    ->allow_extra_args(false);
  AddNumber(*app, "--edge-distance", command->EdgeDistance, { "0 to 1e9 metres", 0.0, 1e9 },
    "EdgeTrust: distance in metres that the data must reach, 0 (any terrain at all) or more.\n"
    "Default: 1000, or a tenth of the shorter side of the DEM if that is less")
    ->type_name("METRES");
  command->Horizon.AddTo(*app);
  AddCommonOptions(*app, command->Common);
  RunAfterCheck(*app, command);
}

} // namespace skyline
