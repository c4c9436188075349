// SPDX-License-Identifier: BSD-3-Clause
#include "GrassHorizon.h"

#include "Measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace skyline
{
namespace benchmark
{

namespace
{

namespace fs = std::filesystem;

constexpr float Null = -99999.0f; // a missing post on its way in and out

// What a shell command prints.
std::string Answer(const char* command)
{
  std::string text;
  if (FILE* pipe = popen(command, "r"))
  {
    std::array<char, 256> buffer{};
    while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr)
    {
      text += buffer.data();
    }
    pclose(pipe);
  }
  return text.substr(0, text.find('\n'));
}

struct ProgramCost
{
  double Cpu = 0.0, Wall = 0.0;
};

// Runs a program, silent; throws if it fails.
ProgramCost RunProgram(const std::vector<std::string>& words)
{
  std::vector<char*> arguments;
  for (const std::string& word : words)
  {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);
  const double start = Now().Wall;
  const pid_t child = fork();
  if (child == 0)
  {
    const int nowhere = open("/dev/null", O_RDWR);
    dup2(nowhere, 0);
    dup2(nowhere, 1);
    dup2(nowhere, 2);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 1;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0)
  {
    throw std::runtime_error(fs::path(words[0]).filename().string() + " failed");
  }
  const auto seconds = [](const timeval& time)
  { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return { seconds(usage.ru_utime) + seconds(usage.ru_stime), Now().Wall - start };
}

// A GRASS database with one location, on a sphere's transverse Mercator with the data about its
// origin: there grid north is north to 1e-3 degrees.
class Location
{
public:
  Location(const oracle::OracleField& field, const std::string& base)
    : Field(field)
    , Base(base)
  {
    std::string name = (fs::temp_directory_path() / "skyline-grass-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
    {
      throw std::runtime_error("no temporary folder");
    }
    this->Folder = name;
    const fs::path mapset = this->Folder / "place" / "PERMANENT";
    fs::create_directories(mapset);
    std::ofstream(this->Folder / "session")
      << "GISDBASE: " << name << "\nLOCATION_NAME: place\nMAPSET: PERMANENT\nGUI: text\n";
    std::ofstream(mapset / "PROJ_INFO") << "name: Local\nproj: tmerc\nlat_0: 0\nlon_0: 0\nk: 1\n"
                                           "x_0: 0\ny_0: 0\nellps: sphere\nno_defs: defined\n";
    std::ofstream(mapset / "PROJ_UNITS") << "unit: meter\nunits: meters\nmeters: 1\n";
    for (const char* window : { "DEFAULT_WIND", "WIND" })
    {
      std::ofstream(mapset / window)
        << "proj: 99\nzone: 0\nnorth: " << this->North() << "\nsouth: " << -this->North()
        << "\neast: " << this->East() << "\nwest: " << -this->East() << "\ncols: " << field.Columns
        << "\nrows: " << field.Rows << "\ne-w resol: " << field.SpacingX
        << "\nn-s resol: " << field.SpacingY
        << "\ntop: 1\nbottom: 0\ncols3: " << field.Columns << "\nrows3: " << field.Rows
        << "\ndepths: 1\ne-w resol3: " << field.SpacingX << "\nn-s resol3: " << field.SpacingY
        << "\nt-b resol: 1\n";
    }
    setenv("GISBASE", base.c_str(), 1);
    setenv("GISRC", (this->Folder / "session").c_str(), 1);
    setenv("LD_LIBRARY_PATH", (base + "/lib").c_str(), 1);
  }
  ~Location()
  {
    std::error_code ignored;
    fs::remove_all(this->Folder, ignored);
  }
  Location(const Location&) = delete;
  Location& operator=(const Location&) = delete;

  ProgramCost Run(const std::string& module, std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), this->Base + "/bin/" + module);
    return RunProgram(arguments);
  }

  std::string File(const char* name) const { return (this->Folder / name).string(); }

  // Rasters run from the north there.
  void ImportHeights() const
  {
    const oracle::OracleField& field = this->Field;
    std::ofstream file(this->File("heights"), std::ios::binary);
    for (std::ptrdiff_t row = field.Rows - 1; row >= 0; --row)
    {
      for (std::ptrdiff_t column = 0; column < field.Columns; ++column)
      {
        const double height = field.At(column, row);
        const float value = std::isfinite(height) ? static_cast<float>(height) : Null;
        file.write(reinterpret_cast<const char*>(&value), sizeof value);
      }
    }
    file.close();
    this->Run("r.in.bin",
      { "-f", "input=" + this->File("heights"), "output=heights", "order=native",
        "anull=" + std::to_string(Null), "north=" + std::to_string(this->North()),
        "south=" + std::to_string(-this->North()), "east=" + std::to_string(this->East()),
        "west=" + std::to_string(-this->East()), "rows=" + std::to_string(field.Rows),
        "cols=" + std::to_string(field.Columns) });
  }

  /// Row by row from the north.
  std::vector<float> Export(const std::string& raster) const
  {
    this->Run("r.out.bin", { "-f", "input=" + raster, "output=" + this->File("values"),
                             "order=native", "null=" + std::to_string(Null) });
    std::vector<float> values(this->Field.Heights.size());
    std::ifstream file(this->File("values"), std::ios::binary);
    file.read(reinterpret_cast<char*>(values.data()),
      static_cast<std::streamsize>(values.size() * sizeof(float)));
    if (!file)
    {
      throw std::runtime_error("r.out.bin wrote too little");
    }
    return values;
  }

private:
  const oracle::OracleField& Field;
  std::string Base;
  fs::path Folder;

  // Edges of the raster, half a spacing beyond its posts.
  double North() const { return 0.5 * static_cast<double>(this->Field.Rows) * this->Field.SpacingY; }
  double East() const
  {
    return 0.5 * static_cast<double>(this->Field.Columns) * this->Field.SpacingX;
  }
};

// The one raster that r.horizon wrote; its name carries the angle in a way that differs by release.
std::string NewRaster(const fs::path& cells)
{
  for (const auto& entry : fs::directory_iterator(cells))
  {
    const std::string name = entry.path().filename().string();
    if (name.rfind("horizon", 0) == 0)
    {
      return name;
    }
  }
  throw std::runtime_error("r.horizon wrote no raster");
}

} // namespace

std::string GrassVersion()
{
  const std::string line = Answer("grass --version 2>&1");
  const std::string name = "GRASS GIS ";
  return line.rfind(name, 0) == 0 ? line.substr(name.size()) : "not installed";
}

Result MeasureGrass(const Scene& scene, const Truth& truth, int azimuths)
{
  const std::string base = Answer("grass --config path 2>/dev/null");
  if (base.empty() || !fs::exists(base + "/bin/r.horizon"))
  {
    throw std::runtime_error("not installed");
  }
  const oracle::OracleField& field = scene.Field;
  const Location location(field, base);
  location.ImportHeights();

  ProgramCost sum;
  ErrorSum errors;
  for (int k = 0; k < azimuths; ++k)
  {
    // Spread over the circle, and off its axes and diagonals.
    const std::size_t count = truth.Azimuths.size();
    const std::size_t index = (count * static_cast<std::size_t>(8 * k + 3)) /
        static_cast<std::size_t>(8 * azimuths) % count;
    const double angle = std::fmod(450.0 - truth.Azimuths[index], 360.0); // from east, to the left
    const ProgramCost cost = location.Run("r.horizon",
      { "-d", "elevation=heights", "direction=" + std::to_string(angle), "output=horizon" });
    sum.Cpu += cost.Cpu;
    sum.Wall += cost.Wall;

    const std::string raster =
      NewRaster(location.File("place") + std::string("/PERMANENT/fcell"));
    const std::vector<float> found = location.Export(raster);
    for (std::size_t i = 0; i < truth.Posts.size(); ++i)
    {
      const std::ptrdiff_t row = field.Rows - 1 - truth.Posts[i] / field.Columns;
      const std::ptrdiff_t post = row * field.Columns + truth.Posts[i] % field.Columns;
      const float value = found[static_cast<std::size_t>(post)];
      if (value != Null)
      {
        errors.Add(value, truth.Elevation(index, i));
      }
    }
    for (const char* part : { "fcell", "cell", "cell_misc", "cellhd", "cats", "colr", "hist" })
    {
      std::error_code ignored;
      fs::remove_all(location.File("place") + "/PERMANENT/" + part + "/" + raster, ignored);
    }
  }
  Result result;
  Laps laps;
  laps.Add({}, { sum.Cpu, sum.Wall });
  laps.Report(result, static_cast<double>(field.Heights.size()) * azimuths);
  result.PrepareNs = NotMeasured;
  result.SearchNs = NotMeasured;
  result.Error = errors.Get();
  std::snprintf(result.Reason, sizeof result.Reason,
    "%d azimuths, start and files included", azimuths);
  result.Ran = true;
  return result;
}

} // namespace benchmark
} // namespace skyline
