// SPDX-License-Identifier: BSD-3-Clause
// Draws figures of SN08, THESIS, SHM and TW10, each as a sheet of pictures, and prints their errors
// against direct integration.
#include "Sheet.h"
#include "Studio.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>

namespace
{

using namespace skyline::gallery;

/// The exit code that tells ctest that a test could not run.
constexpr int Skipped = 77;

void Print(const std::string& name, const Figure& figure)
{
  std::printf(
    "%s\n\n| setting | against | rms | 95 %% | largest |\n| --- | --- | --- | --- | --- |\n",
    (name + ": " + figure.Title).c_str());
  for (const Measurement& line : figure.Table)
  {
    std::printf("| %s | %s | %.2f | %.2f | %.1f |\n", line.Setting.c_str(), line.Against.c_str(),
      100.0 * line.Error.Rms, 100.0 * line.Error.Most, 100.0 * line.Error.Largest);
  }
  if (!figure.Numbers.empty())
  {
    std::printf("\n| setting | what | value |\n| --- | --- | --- |\n");
  }
  for (const Number& line : figure.Numbers)
  {
    std::printf("| %s | %s | %.3g |\n", line.Setting.c_str(), line.What.c_str(), line.Value);
  }
  std::printf("\n");
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<FigureMaker> makers = KeyFigures();
  for (FigureMaker& maker : LampFigures())
  {
    makers.push_back(std::move(maker));
  }
  for (FigureMaker& maker : ShadowFigures())
  {
    makers.push_back(std::move(maker));
  }
  std::vector<std::string> names;
  names.reserve(makers.size());
  for (const FigureMaker& maker : makers)
  {
    names.push_back(maker.Name);
  }
  CLI::App app("Makes the papers' figures and prints their errors, in percent of the open light "
               "(SN08) or of the root mean square irradiance (THESIS, TW10)");
  std::string folder;
  std::vector<std::string> wanted;
  Scale scale;
  app.add_option("-o,--output", folder, "Folder for the pictures")->required();
  app.add_option("--figure", wanted, "Only these figures")->check(CLI::IsMember(names));
  app.add_flag("--quick", scale.Quick, "Small fields and pictures, to test the program");
  CLI11_PARSE(app, argc, argv);

  Studio studio;
  std::string reason;
  if (!studio.Open(reason))
  {
    std::cerr << "SkylineGallery: no OpenGL to draw with: " << reason << std::endl;
    return Skipped;
  }
  try
  {
    std::filesystem::create_directories(folder);
    for (const FigureMaker& maker : makers)
    {
      if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), maker.Name) == wanted.end())
      {
        continue;
      }
      const Figure figure = maker.Make(studio, scale);
      const std::string path = folder + "/" + maker.Name + ".png";
      if (!WritePng(SheetOf(figure), path))
      {
        std::cerr << "SkylineGallery: cannot write " << path << std::endl;
        return 1;
      }
      Print(maker.Name, figure);
    }
  }
  catch (const std::exception& failure)
  {
    std::cerr << "SkylineGallery: " << failure.what() << std::endl;
    return 1;
  }
  return 0;
}
