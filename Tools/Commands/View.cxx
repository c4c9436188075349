// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Failure.h"
#include "LightOptions.h"
#include "LookOptions.h"
#include "Options.h"
#include "Perspective.h"

#include "GlfwWindow.h"
#include "Viewer.h"
#include "ViewerInput.h"

#include "vtkGenericOpenGLRenderWindow.h"

#include <filesystem>
#include <memory>
#include <string>

namespace
{

// The bundled DEM. Its path relative to the program is the same in the build and the install tree.
std::string BundledTerrain()
{
  std::error_code none;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", none);
  const auto file = (program.parent_path() / SKYLINE_SHARE_FROM_BIN / "SainteHelens.tif");
  if (none || !std::filesystem::exists(file))
  {
    throw skyline::Failure(
      "no DEM is given, and '" + file.lexically_normal().string() + "' does not exist; give a DEM");
  }
  return file.lexically_normal().string();
}

struct ViewCommand
{
  skyline::ViewerOptions Options;
  skyline::LookOptions Look;
  skyline::PerspectiveOptions Perspective;
  skyline::CommonOptions Common;

  void Check(const skyline::UnusedOptions& options) const
  {
    this->Options.Horizon.RefuseUnused(options);
    skyline::RefuseUnusedSun(this->Options.Lights.Sun, options);
  }

  void Run()
  {
    skyline::PrepareVtk(this->Common);
    skyline::WarnOfZone(this->Options.Lights.Sun, this->Common);
    if (this->Options.Terrain.File.empty())
    {
      this->Options.Terrain.File = BundledTerrain();
    }
    this->Options.Colors = this->Look.Colors;
    this->Options.Exposure = this->Look.Exposure;
    this->Options.Exaggeration = this->Look.Exaggeration;
    int width = 0;
    int height = 0;
    this->Perspective.Read(width, height, this->Options.FromAzimuth, this->Options.FromElevation);
    skyline::GlfwWindow window(width, height); // before any work, since there may be no display
    skyline::Viewer viewer(window.GetRenderWindow(), this->Options, this->Common);
    window.Run(viewer, this->Common);
  }
};

} // namespace

namespace skyline
{

void AddView(CLI::App& program)
{
  CLI::App* app =
    program.add_subcommand("view", "Open a window on the terrain, to drag the camera and the sun");
  const auto command = std::make_shared<ViewCommand>();
  command->Options.Horizon.Azimuths = 72;
  command->Perspective.Size = "1280x800";
  app->footer(
    std::string(
      "Without a DEM, the bundled Mount St Helens is shown. Without --sun and --time, a DEM on\n"
      "the Earth starts in the afternoon of its longest day, and another DEM with the sun at\n"
      "azimuth 315, elevation 45. Screenshots are written to the current folder.\n\n"
      "In the window:\n") +
    ViewerHelp());
  command->Options.Terrain.AddTo(*app);
  app->get_option("DEM")->required(false);
  AddSunOptions(*app, command->Options.Lights.Sun);
  AddPictureSkyOption(*app, command->Options.Lights);
  AddLampOptions(*app, command->Options.Lights);
  command->Look.AddTo(*app);
  command->Perspective.AddTo(*app);
  command->Options.Horizon.AddTo(*app);
  AddCommonOptions(*app, command->Common);
  RunAfterCheck(*app, command);
}

} // namespace skyline
