// SPDX-License-Identifier: BSD-3-Clause
#include "Data/MemoryDemand.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <sys/resource.h>
#include <unistd.h>

namespace skyline
{

namespace
{

constexpr double Gigabyte = 1.0e9;
constexpr double SmallDemand = 0.25 * Gigabyte;
constexpr double Unlimited = std::numeric_limits<double>::infinity();

std::string InGigabytes(double bytes)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f GB", bytes / Gigabyte);
  return text;
}

/// The number at the start of a file; Unlimited for "max" or if the file does not exist.
double ReadNumber(const std::string& file)
{
  std::ifstream stream(file);
  double number = 0.0;
  return stream >> number ? number : Unlimited;
}

/// The value of `key` in a file of key-value pairs; 0 if it is absent.
double ReadItem(const std::string& file, const std::string& key)
{
  std::ifstream lines(file);
  std::string word;
  double number = 0.0;
  while (lines >> word >> number)
  {
    if (word == key)
    {
      return number;
    }
  }
  return 0.0;
}

struct Machine
{
  double Memory = 0.0, Swap = 0.0; // bytes that are free; Memory is Unlimited if unknown
};

Machine FreeOfMachine(const std::string& root)
{
  std::ifstream file(root + "/proc/meminfo");
  Machine machine;
  std::string word;
  while (file >> word)
  {
    double kibibytes = 0.0;
    if (word == "MemAvailable:" && file >> kibibytes)
    {
      machine.Memory += 1024.0 * kibibytes;
    }
    else if (word == "SwapFree:" && file >> kibibytes)
    {
      machine.Swap += 1024.0 * kibibytes;
    }
  }
  machine.Memory = machine.Memory > 0.0 ? machine.Memory : Unlimited;
  return machine;
}

/// Free memory of one control group. Its page cache (inactive_file) counts as free, because the
/// system drops it when memory runs short.
double FreeOfGroup(const std::string& folder, bool second, double swap)
{
  const double limit = ReadNumber(folder + (second ? "/memory.max" : "/memory.limit_in_bytes"));
  const double used = ReadNumber(folder + (second ? "/memory.current" : "/memory.usage_in_bytes"));
  if (!(limit < Unlimited) || !(used < Unlimited))
  {
    return Unlimited;
  }
  const double files =
    ReadItem(folder + "/memory.stat", second ? "inactive_file" : "total_inactive_file");
  double swapped = 0.0;
  if (second)
  {
    const double most = ReadNumber(folder + "/memory.swap.max");
    const double taken = ReadNumber(folder + "/memory.swap.current");
    swapped = taken < Unlimited ? std::min(swap, std::max(most - taken, 0.0)) : 0.0;
  }
  return std::max(limit - used + files, 0.0) + swapped;
}

/// The least free memory of the control groups of the process and of their parents. In a container,
/// /proc often shows the names of the host, and the container's own group is the root; therefore
/// the root is always included.
double FreeOfGroups(const std::string& root, double swap)
{
  std::ifstream groups(root + "/proc/self/cgroup");
  std::string line;
  double least = Unlimited;
  while (std::getline(groups, line)) // number:controllers:path
  {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos)
    {
      continue;
    }
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const bool unified = controllers == ",,";
    if (!unified && controllers.find(",memory,") == std::string::npos)
    {
      continue;
    }
    const std::string top = root + (unified ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory");
    std::string path = line.substr(second + 1);
    while (!path.empty())
    {
      least = std::min(least, FreeOfGroup(top + (path == "/" ? "" : path), unified, swap));
      const std::size_t slash = path.rfind('/');
      path = path == "/" || slash == std::string::npos
        ? ""
        : path.substr(0, std::max<std::size_t>(slash, 1));
    }
  }
  return least;
}

/// Bytes of address space that remain under the limit of the process (ulimit -v).
double FreeOfAddresses()
{
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
  {
    return Unlimited;
  }
  const double used = ReadNumber("/proc/self/statm") * static_cast<double>(sysconf(_SC_PAGESIZE));
  return used < Unlimited ? std::max(static_cast<double>(limit.rlim_cur) - used, 0.0) : Unlimited;
}

} // namespace

double FreeMemory(const std::string& root)
{
  const Machine machine = FreeOfMachine(root);
  return std::min({ machine.Memory + machine.Swap, FreeOfGroups(root, machine.Swap),
    root.empty() ? FreeOfAddresses() : Unlimited });
}

void DemandMemory(
  const std::string& what, std::ptrdiff_t columns, std::ptrdiff_t rows, double bytes, double free)
{
  const double needed = bytes * static_cast<double>(columns) * static_cast<double>(rows);
  if (needed > free)
  {
    throw std::runtime_error(what + " of " + std::to_string(columns) + " x " +
      std::to_string(rows) + " posts take " + InGigabytes(needed) + " more (" +
      std::to_string(std::lround(bytes)) + " bytes per post) and " + InGigabytes(free) +
      " are free; " + MemoryAdvice);
  }
}

void DemandMemory(
  const std::string& what, std::ptrdiff_t columns, std::ptrdiff_t rows, double bytes)
{
  if (bytes * static_cast<double>(columns) * static_cast<double>(rows) > SmallDemand)
  {
    // Memory beyond the range of std::ptrdiff_t cannot be allocated, even if the system reports it
    // as free.
    constexpr auto most = static_cast<double>(std::numeric_limits<std::ptrdiff_t>::max());
    DemandMemory(what, columns, rows, bytes, std::min(FreeMemory(), most));
  }
}

} // namespace skyline
