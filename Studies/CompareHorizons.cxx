// SPDX-License-Identifier: BSD-3-Clause
// Compares error, run time and memory of all horizon methods and of other programs in one run.
#include "Azimuths.h"
#include "HorizonTable.h"
#include "Machine.h"
#include "Methods.h"
#include "Scenes.h"

#include "Measure.h"
#include "vtkSMPTools.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace
{

using namespace skyline;
using namespace skyline::benchmark;

struct Options
{
  int Size = 1024;
  int Azimuths = 64;
  int Posts = 2048;
  std::uint64_t Seed = 1;
  std::vector<std::string> Scenes;
  std::vector<std::string> MethodNames;
  std::vector<std::string> Rasters;
  std::string Csv;
  bool Quick = false;
  Plan How;
};

// With --quick, options that were not given get small values.
void MakeQuick(Options& options, const CLI::App& app)
{
  const auto shrink = [&](const char* name, int& value, int small)
  { value = app.count(name) == 0 ? small : value; };
  shrink("--size", options.Size, 128);
  shrink("--azimuths", options.Azimuths, 8);
  shrink("--posts", options.Posts, 256);
  shrink("--repeats", options.How.Repeats, 1);
  options.How.Thin = 1;
  options.How.GrassAzimuths = 1;
  if (options.Scenes.empty())
  {
    options.Scenes = { "hills", "walls", "helens" };
  }
}

std::vector<const Method*> Chosen(const std::vector<std::string>& names)
{
  std::vector<const Method*> methods;
  for (const Method& method : Methods())
  {
    if (names.empty() || std::find(names.begin(), names.end(), method.Name) != names.end())
    {
      methods.push_back(&method);
    }
  }
  return methods;
}

// Runs the method once on a small scene, so that the memory of its code does not count as memory of
// the method.
void Warm(const Method& method)
{
  const Scene scene = MakeScene("hills", 32);
  Plan once;
  once.Repeats = once.GrassAzimuths = 1;
  method.Measure(scene, ReferenceHorizons(scene, 1, EvenDegrees(8), 1), once);
}

std::vector<Row> Run(const Options& options)
{
  std::vector<std::string> scenes = options.Scenes;
  scenes.erase(std::remove(scenes.begin(), scenes.end(), "none"), scenes.end());
  scenes.insert(scenes.end(), options.Rasters.begin(), options.Rasters.end());
  std::vector<Row> rows;
  for (const std::string& name : scenes)
  {
    const Scene scene = MakeScene(name, options.Size);
    std::cout << scene.Name << ": " << scene.Description << std::endl;
    std::cerr << scene.Name << ": oracle" << std::endl;
    const ReferenceHorizons truth(
      scene, options.Posts, EvenDegrees(options.Azimuths), options.Seed);
    for (const Method* method : Chosen(options.MethodNames))
    {
      std::cerr << scene.Name << ": " << method->Label << std::endl;
      rows.push_back({ scene.Name, method->Name, method->Label,
        InChild(
          [&]
          {
            Warm(*method);
            return method->Measure(scene, truth, options.How);
          }) });
    }
  }
  return rows;
}

// Adds an option that takes a comma-separated list of known names.
CLI::Option* AddNames(CLI::App& app, const std::string& option, std::vector<std::string>& names,
  const std::string& what, const std::vector<std::string>& known)
{
  return app.add_option(option, names, what)
    ->delimiter(',')
    ->allow_extra_args(false)
    ->check(CLI::IsMember(known));
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  std::vector<std::string> methodNames;
  for (const Method& method : Methods())
  {
    methodNames.push_back(method.Name);
  }
  CLI::App app("Prints error, time and memory of all horizon methods, in one table.");
  app.add_option("--size", options.Size, "posts per side of the generated scenes")
    ->check(CLI::Range(16, 16384))
    ->capture_default_str();
  app.add_option("--azimuths", options.Azimuths, "azimuths around")
    ->check(CLI::Range(1, MaximumAzimuths))
    ->capture_default_str();
  app.add_option("--posts", options.Posts, "random posts that are compared with the oracle")
    ->check(CLI::Range(1, 1000000))
    ->capture_default_str();
  app.add_option("--seed", options.Seed, "seed of the random posts")->capture_default_str();
  app.add_option("--repeats", options.How.Repeats, "repeats of each timed run")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  std::vector<std::string> sceneNames = SceneNames();
  sceneNames.push_back("none");
  AddNames(app, "--scenes", options.Scenes, "only these scenes; none: only the DEMs", sceneNames);
  AddNames(app, "--methods", options.MethodNames, "only these methods", methodNames);
  app.add_option("--csv", options.Csv, "write the table to this file too");
  app.add_flag("--quick", options.Quick, "small scenes and few azimuths, to test the program");
  app.add_option("DEM", options.Rasters, "rasters that are used as further scenes");
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& failure)
  {
    return app.exit(failure) == 0 ? 0 : 2; // 0: --help
  }

  // One core: the driver of the filters runs here, and a fork copies no other threads.
  vtkSMPTools::SetBackend("Sequential");
  try
  {
    if (options.Quick)
    {
      MakeQuick(options, app);
    }
    if (options.Scenes.empty())
    {
      options.Scenes = SceneNames();
    }
    std::cout << DescribeMachine() << std::endl;
    const std::vector<Row> rows = Run(options);
    std::cout << "\n" << DescribeMethods() << "\n";
    PrintTable(std::cout, rows);
    std::cout << "\n";
    PrintRatios(std::cout, rows);
    std::cout << "\nload at the end: " << Load() << std::endl;
    if (!options.Csv.empty())
    {
      std::ofstream file(options.Csv);
      PrintCsv(file, rows);
      if (!file.flush())
      {
        throw std::runtime_error("cannot write " + options.Csv);
      }
    }
  }
  catch (const std::exception& failure)
  {
    std::cerr << "SkylineBenchmark: " << failure.what() << std::endl;
    return 1;
  }
  return 0;
}
