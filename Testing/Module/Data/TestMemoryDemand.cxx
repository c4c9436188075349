// SPDX-License-Identifier: BSD-3-Clause
// Data that exceed the memory are refused before any work. The message states the bytes and what to
// do.
#include "Data/MemoryDemand.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

namespace skyline
{
namespace testing
{
namespace
{

TEST(MemoryDemand, NamesBytesAndCure)
{
  try
  {
    DemandMemory("horizons", 40000, 40000, 148.0, 17.0e9);
    FAIL() << "236.8 GB were found in 17";
  }
  catch (const std::runtime_error& reason)
  {
    EXPECT_STREQ(reason.what(),
      "horizons of 40000 x 40000 posts take 236.8 GB more (148 bytes per post) and 17.0 GB are free; "
      "ask for less at a time, cut the raster (gdal_translate -srcwin) or make it coarser (-tr)");
  }
}

TEST(MemoryDemand, TakesWhatFits)
{
  DemandMemory("horizons", 40000, 40000, 8.0, 12.8e9);
  DemandMemory("horizons", 40000, 40000, 1.0e6, std::numeric_limits<double>::infinity());
  EXPECT_GT(FreeMemory(), 0.0);
}

// A folder in place of /, with the files in which Linux reports memory.
class MemoryFolder
{
public:
  explicit MemoryFolder(const std::string& name)
    : Root(std::string(SKYLINE_TEST_OUTPUT) + "/" + name)
  {
    std::filesystem::remove_all(this->Root);
    this->Say(
      "/proc/meminfo", "MemTotal: 32000000 kB\nMemAvailable: 16000000 kB\nSwapFree: 1000000 kB\n");
  }
  void Say(const std::string& file, const std::string& text) const
  {
    std::filesystem::create_directories(std::filesystem::path(this->Root + file).parent_path());
    std::ofstream(this->Root + file) << text;
  }
  double Free() const { return FreeMemory(this->Root); }

private:
  std::string Root;
};

constexpr double Swap = 1024e6;
constexpr double Machine = 16384e6 + Swap;

TEST(MemoryDemand, MachineWithoutLimits)
{
  const MemoryFolder folder("memory-machine");
  EXPECT_EQ(folder.Free(), Machine);
  folder.Say("/proc/self/cgroup", "0::/user.slice\n");
  folder.Say("/sys/fs/cgroup/user.slice/memory.max", "max\n");
  folder.Say("/sys/fs/cgroup/user.slice/memory.current", "5\n");
  EXPECT_EQ(folder.Free(), Machine);
}

// In a container, the path is that of the host, and the limit is in the root folder.
TEST(MemoryDemand, ContainerOfControlGroupsTwo)
{
  const MemoryFolder folder("memory-two");
  folder.Say("/proc/self/cgroup", "0::/\n");
  folder.Say("/sys/fs/cgroup/memory.max", "2000000000\n");
  folder.Say("/sys/fs/cgroup/memory.current", "700000000\n");
  folder.Say("/sys/fs/cgroup/memory.stat", "anon 600000000\ninactive_file 100000000\n");
  EXPECT_EQ(folder.Free(), 1.4e9);
  folder.Say("/sys/fs/cgroup/memory.swap.max", "500000000\n");
  folder.Say("/sys/fs/cgroup/memory.swap.current", "0\n");
  EXPECT_EQ(folder.Free(), 1.9e9);
  folder.Say("/sys/fs/cgroup/memory.swap.max", "max\n");
  EXPECT_EQ(folder.Free(), 1.4e9 + Swap);
}

TEST(MemoryDemand, TheTightestGroupAboveCounts)
{
  const MemoryFolder folder("memory-nested");
  folder.Say("/proc/self/cgroup", "0::/batch/job\n");
  folder.Say("/sys/fs/cgroup/batch/job/memory.max", "9000000000\n");
  folder.Say("/sys/fs/cgroup/batch/job/memory.current", "0\n");
  folder.Say("/sys/fs/cgroup/batch/memory.max", "3000000000\n");
  folder.Say("/sys/fs/cgroup/batch/memory.current", "1000000000\n");
  EXPECT_EQ(folder.Free(), 2.0e9);
}

TEST(MemoryDemand, ContainerOfControlGroupsOne)
{
  const MemoryFolder folder("memory-one");
  folder.Say("/proc/self/cgroup", "5:cpu,cpuacct:/docker/abc\n4:memory:/docker/abc\n");
  folder.Say("/sys/fs/cgroup/memory/memory.limit_in_bytes", "1000000000\n");
  folder.Say("/sys/fs/cgroup/memory/memory.usage_in_bytes", "400000000\n");
  folder.Say("/sys/fs/cgroup/memory/memory.stat", "total_inactive_file 50000000\n");
  EXPECT_EQ(folder.Free(), 6.5e8);
}

} // namespace
} // namespace testing
} // namespace skyline
