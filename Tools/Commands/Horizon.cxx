// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Files.h"
#include "Options.h"

#include "vtkHeightFieldHorizon.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <memory>

namespace
{

struct HorizonCommand
{
  skyline::TerrainOptions Terrain;
  skyline::OutputOptions Output;
  skyline::HorizonOptions Horizon;
  skyline::CommonOptions Common;

  void Check(const skyline::UnusedOptions& options) const { this->Horizon.RefuseUnused(options); }

  void Run() const
  {
    skyline::PrepareVtk(this->Common);
    skyline::CheckRasterOutput(this->Output.File, { this->Terrain.File });
    const auto terrain = skyline::ReadTerrain(this->Terrain, this->Common, this->Output.File);
    this->Horizon.WarnUnused(terrain, this->Common);

    vtkNew<vtkHeightFieldHorizon> horizon;
    horizon->SetInputData(terrain);
    horizon->SetNumberOfAzimuths(this->Horizon.Azimuths);
    this->Horizon.Apply(horizon.Get());
    skyline::RunPass(horizon, "horizon", this->Common);

    skyline::WriteRaster(horizon, { "HorizonElevation" }, this->Output, this->Common);
  }
};

} // namespace

namespace skyline
{

void AddHorizon(CLI::App& program)
{
  CLI::App* app = program.add_subcommand(
    "horizon", "Compute the elevation angle of the horizon around every post");
  const auto command = std::make_shared<HorizonCommand>();
  app->footer(
    "Writes a GeoTIFF of float32 with one band per azimuth: the elevation of the horizon in\n"
    "degrees, -90 to 90. Band k is for the azimuth 360 (k - 1) / N degrees clockwise from\n"
    "grid north. The value is -90 where no terrain lies in that direction.");
  command->Terrain.AddTo(*app);
  command->Output.AddTo(*app, "GeoTIFF to write");
  command->Horizon.AddTo(*app);
  AddCommonOptions(*app, command->Common);
  RunAfterCheck(*app, command);
}

} // namespace skyline
