// SPDX-License-Identifier: BSD-3-Clause
#include "Machine.h"

#include "EmbreeHorizon.h"
#include "External.h"
#include "GrassHorizon.h"

#include "hwy/targets.h"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <sstream>
#include <thread>

namespace skyline
{
namespace benchmark
{

namespace
{

std::string Processor()
{
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line))
  {
    if (line.rfind("model name", 0) == 0)
    {
      return line.substr(line.find(':') + 2);
    }
  }
  return "unknown";
}

// The instruction set that Highway selects. Each target is a bit; the best one is the lowest.
std::string VectorTarget()
{
  const auto targets = hwy::SupportedTargets() & (HWY_TARGETS);
  return hwy::TargetName(targets & -targets);
}

std::string Compiler()
{
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "gcc " __VERSION__;
#else
  return "unknown";
#endif
}

std::string Date()
{
  const std::time_t now = std::time(nullptr);
  char text[40];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return text;
}

} // namespace

std::string Load()
{
  std::ifstream file("/proc/loadavg");
  std::string one, five, fifteen;
  file >> one >> five >> fifteen;
  return one + " " + five + " " + fifteen;
}

std::vector<std::pair<std::string, std::string>> MachineFacts()
{
  const auto installed = [](const std::string& line)
  { return line.empty() ? "not installed" : line; };
  return { { "date", Date() },
    { "processor",
      Processor() + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores, load " +
        Load() },
    { "vectors", VectorTarget() }, { "compiler", Compiler() }, { "Embree", EmbreeVersion() },
    { "GRASS", GrassVersion() }, { "SAGA", installed(FirstLine("saga_cmd --version 2>/dev/null")) },
    { "gdaldem", installed(FirstLine("gdalinfo --version 2>/dev/null")) } };
}

std::string DescribeMachine()
{
  constexpr std::size_t width = 16; // width of the column of names
  std::ostringstream text;
  for (const auto& [name, value] : MachineFacts())
  {
    text << name << ":" << std::string(width - 1 - std::min(width - 1, name.size()), ' ') << value
         << "\n";
  }
  return text.str();
}

} // namespace benchmark
} // namespace skyline
