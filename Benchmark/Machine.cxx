// SPDX-License-Identifier: BSD-3-Clause
#include "Machine.h"

#include "EmbreeHorizon.h"
#include "GrassHorizon.h"

#include "hwy/targets.h"

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

// The one that Highway's dispatch takes: targets are bits, the best is the lowest.
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

std::string DescribeMachine()
{
  std::ostringstream text;
  text << "date:           " << Date() << "\n"
       << "processor:      " << Processor() << ", " << std::thread::hardware_concurrency()
       << " cores, load " << Load() << "\n"
       << "vectors:        " << VectorTarget() << "\n"
       << "compiler:       " << Compiler() << "\n"
       << "Embree:         " << EmbreeVersion() << "\n"
       << "GRASS:          " << GrassVersion() << "\n";
  return text.str();
}

} // namespace benchmark
} // namespace skyline
