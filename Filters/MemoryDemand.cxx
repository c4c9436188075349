// SPDX-License-Identifier: BSD-3-Clause
#include "MemoryDemand.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace skyline
{

namespace
{

constexpr double Gigabyte = 1.0e9;
constexpr double SmallDemand = 0.25 * Gigabyte;

std::string InGigabytes(double bytes)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f GB", bytes / Gigabyte);
  return text;
}

} // namespace

double FreeMemory()
{
  std::ifstream file("/proc/meminfo");
  double free = 0.0;
  std::string word;
  while (file >> word)
  {
    double kibibytes = 0.0;
    if ((word == "MemAvailable:" || word == "SwapFree:") && file >> kibibytes)
    {
      free += 1024.0 * kibibytes;
    }
  }
  return free > 0.0 ? free : std::numeric_limits<double>::infinity();
}

void DemandMemory(
  const std::string& what, std::ptrdiff_t columns, std::ptrdiff_t rows, double bytes, double free)
{
  const double needed = bytes * static_cast<double>(columns) * static_cast<double>(rows);
  if (needed > free)
  {
    throw std::runtime_error(what + " of " + std::to_string(columns) + " x " +
      std::to_string(rows) + " posts take " + InGigabytes(needed) + " more (" +
      std::to_string(std::lround(bytes)) + " bytes a post) and " + InGigabytes(free) +
      " are free; ask for less at a time, cut the raster (gdal_translate -srcwin) or make it "
      "coarser (-tr)");
  }
}

void DemandMemory(
  const std::string& what, std::ptrdiff_t columns, std::ptrdiff_t rows, double bytes)
{
  if (bytes * static_cast<double>(columns) * static_cast<double>(rows) > SmallDemand)
  {
    DemandMemory(what, columns, rows, bytes, FreeMemory());
  }
}

} // namespace skyline
