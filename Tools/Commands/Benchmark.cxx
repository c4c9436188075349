// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "AtomicFile.h"
#include "Failure.h"
#include "Interrupt.h"
#include "Options.h"
#include "Report.h"
#include "Scenes.h"
#include "Session.h"
#include "SourceFiles.h"
#include "Values.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <unistd.h>

namespace
{

namespace fs = std::filesystem;
using namespace skyline::benchmark;

constexpr int LeastSize = 32;  // of a synthetic scene; a smaller one has no window of posts
constexpr int MostSize = 4096; // in larger ones the reference takes longer than the methods

constexpr std::array<const char*, 4> ReportFiles{ { "index.html", "results.csv", "results.json",
  "pareto.svg" } };

constexpr double MostBudget = 1e6; // seconds

// The command line as the user typed it, with words that contain spaces in quotes.
std::string CommandLine()
{
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string words, word;
  while (std::getline(file, word, '\0'))
  {
    word = words.empty() ? fs::path(word).filename().string() : word;
    const bool plain = !word.empty() && word.find_first_of(" \t\"'") == std::string::npos;
    words += (words.empty() ? "" : " ") + (plain ? word : "'" + word + "'");
  }
  return words;
}

// The numbers in the form of the option --sizes.
std::string Listed(const std::vector<int>& numbers)
{
  std::string text;
  for (const int number : numbers)
  {
    text += (text.empty() ? "" : ",") + std::to_string(number);
  }
  return text;
}

// The folder of the report. If it was made here and is not filled, it is removed again.
class ReportFolder
{
public:
  explicit ReportFolder(const std::string& path)
    : Path(path)
  {
    std::error_code error;
    if (fs::exists(path) && !fs::is_directory(path))
    {
      throw skyline::Failure(path + " is a file; name a folder for the report");
    }
    this->Made = fs::create_directory(path, error);
    if (error)
    {
      throw skyline::Failure("cannot make the folder " + path + ": " + error.message() +
        "; name another with -o, in a folder that exists");
    }
    if (::access(path.c_str(), W_OK | X_OK) != 0)
    {
      throw skyline::Failure(
        "no permission to write in the folder " + path + "; name another with -o");
    }
  }
  ~ReportFolder()
  {
    std::error_code ignored;
    if (this->Made && !this->Filled)
    {
      fs::remove(this->Path, ignored); // a folder that is not empty stays
    }
  }
  ReportFolder(const ReportFolder&) = delete;
  ReportFolder& operator=(const ReportFolder&) = delete;

  // Writes all files, or none of them if none is in place yet.
  void Fill(const std::vector<std::pair<std::string, std::string>>& texts)
  {
    std::vector<std::unique_ptr<skyline::AtomicFile>> files;
    for (const auto& [name, text] : texts)
    {
      files.push_back(
        std::make_unique<skyline::AtomicFile>((fs::path(this->Path) / name).string()));
      std::ofstream out(files.back()->GetPath(), std::ios::binary);
      out << text;
      if (!out.flush())
      {
        files.back()->Fail("no text could be written");
      }
    }
    skyline::StopIfInterrupted();
    for (const auto& file : files)
    {
      file->Commit();
    }
    this->Filled = true;
  }

private:
  std::string Path;
  bool Made = false;
  bool Filled = false;
};

struct BenchmarkCommand
{
  SessionOptions Options;
  std::string Folder;
  skyline::CommonOptions Common;

  void Run(const std::string& words)
  {
    skyline::PrepareVtk(this->Common);
    if (this->Options.Scenes.empty())
    {
      this->Options.Scenes = SceneNames();
    }
    else if (this->Options.Scenes == std::vector<std::string>{ "none" })
    {
      this->Options.Scenes.clear();
    }
    else if (std::count(this->Options.Scenes.begin(), this->Options.Scenes.end(), "none") > 0)
    {
      throw skyline::WrongUsage(
        "--scenes: none cannot be combined with other scenes; leave it out");
    }
    if (this->Options.Scenes.empty() && this->Options.Rasters.empty())
    {
      throw skyline::WrongUsage(
        "nothing to measure: no scene and no DEM; give a DEM, or leave out --scenes none");
    }
    for (const char* name : ReportFiles)
    {
      skyline::RefuseOverlap((fs::path(this->Folder) / name).string(), this->Options.Rasters);
    }
    ReportFolder folder(this->Folder);
    const bool shown = !this->Common.Quiet && isatty(STDERR_FILENO) != 0;
    const Session session = RunSession(
      this->Options,
      [&](std::size_t done, std::size_t all, const std::string& what)
      {
        if (shown)
        {
          std::fprintf(stderr, "\r\033[K%zu of %zu, %3.0f s at most: %.50s", done + 1, all,
            this->Options.Budget, what.c_str());
        }
      },
      skyline::Interrupted);
    if (shown)
    {
      std::fputs("\r\033[K", stderr);
    }
    skyline::StopIfInterrupted();
    const ReportOrigin origin{ "skyline " SKYLINE_VERSION, words };
    std::vector<std::pair<std::string, std::string>> files{ { "index.html",
                                                              ReportPage(session, origin) },
      { "results.csv", ReportCsv(session) }, { "results.json", ReportJson(session, origin) } };
    const std::string picture = ReportPicture(session);
    if (!picture.empty())
    {
      files.emplace_back("pareto.svg", picture);
    }
    folder.Fill(files);
    if (!this->Common.Quiet)
    {
      std::printf("%s: %zu measurements in %.0f s, %zu left out for lack of time\n",
        (fs::path(this->Folder) / "index.html").c_str(), session.Findings.size(), session.Seconds,
        session.LeftOut.size());
    }
  }
};

} // namespace

namespace skyline
{

void AddBenchmark(CLI::App& program)
{
  CLI::App* app = program.add_subcommand(
    "benchmark", "Measure error and run time of every method, and write a report");
  const auto command = std::make_shared<BenchmarkCommand>();
  app->footer(
    "Writes a folder with index.html (charts and all figures), results.csv, results.json, and the\n"
    "main chart as pareto.svg. The reference visits every crossed edge in double precision, at\n"
    "randomly chosen posts. GRASS, SAGA and gdaldem are measured if they are installed, and\n"
    "Embree if it was installed when skyline was built. Times are CPU times of one thread; other\n"
    "work on the machine makes all of them longer.");
  app
    ->add_option("DEM", command->Options.Rasters,
      "Rasters of heights to use as scenes; of a larger raster, the middle 2048 x 2048 posts")
    ->type_name("");
  app
    ->add_option(
      "-o,--output", command->Folder, "Folder for the report; it is created if it does not exist")
    ->required()
    ->type_name("DIR");
  std::vector<std::string> scenes = SceneNames();
  scenes.emplace_back("none");
  app
    ->add_option("--scenes", command->Options.Scenes,
      "Synthetic scenes and the bundled DEM, separated by commas; none: only the DEMs that are\n"
      "given. Default: all")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->type_name("NAME,...")
    ->check(OneOf(scenes));
  app->add_option("--methods", command->Options.Kinds, "Methods, separated by commas. Default: all")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->type_name("NAME,...")
    ->check(OneOf(Kinds()));
  std::vector<std::string> quantities;
  for (const Quantity& quantity : Quantities())
  {
    quantities.push_back(quantity.Name);
  }
  app
    ->add_option("--quantities", command->Options.Quantities,
      "Quantities to measure, separated by commas. Default: all")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->type_name("NAME,...")
    ->check(OneOf(quantities));
  std::vector<int>& sizes = command->Options.Sizes;
  app
    ->add_option_function<std::vector<std::string>>(
      "--sizes",
      [&sizes](const std::vector<std::string>& texts)
      {
        sizes.clear();
        for (const std::string& text : texts)
        {
          sizes.push_back(static_cast<int>(*ReadNumber(text)));
        }
      },
      "Posts per side of the synthetic scenes, separated by commas; 32 to 4096")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->type_name("N,...")
    ->check(
      CLI::Validator([](std::string& text) { return WhyNotWhole(text, LeastSize, MostSize); }, ""))
    ->default_str(Listed(sizes));
  AddNumber(*app, "--budget", command->Options.Budget,
    { "seconds from 0 to 1000000, as in --budget 600", 0.0, MostBudget },
    "Seconds after which no measurement is started; the most important ones come first")
    ->type_name("SECONDS");
  app->add_flag("-q,--quiet", command->Common.Quiet, "Print no progress and no summary");
  app->callback([command] { command->Run(CommandLine()); });
}

} // namespace skyline
