// SPDX-License-Identifier: BSD-3-Clause
// Data that exceed the memory are refused before any work. The message states the bytes and what to
// do.
#include "Data/MemoryDemand.h"
#include "FilterTesting.h"

#include "vtkHeightFieldHorizon.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
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
class Told
{
public:
  explicit Told(const std::string& name)
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
  const Told told("memory-machine");
  EXPECT_EQ(told.Free(), Machine);
  told.Say("/proc/self/cgroup", "0::/user.slice\n");
  told.Say("/sys/fs/cgroup/user.slice/memory.max", "max\n");
  told.Say("/sys/fs/cgroup/user.slice/memory.current", "5\n");
  EXPECT_EQ(told.Free(), Machine);
}

// In a container, the path is that of the host, and the limit is in the root folder.
TEST(MemoryDemand, ContainerOfControlGroupsTwo)
{
  const Told told("memory-two");
  told.Say("/proc/self/cgroup", "0::/\n");
  told.Say("/sys/fs/cgroup/memory.max", "2000000000\n");
  told.Say("/sys/fs/cgroup/memory.current", "700000000\n");
  told.Say("/sys/fs/cgroup/memory.stat", "anon 600000000\ninactive_file 100000000\n");
  EXPECT_EQ(told.Free(), 1.4e9);
  told.Say("/sys/fs/cgroup/memory.swap.max", "500000000\n");
  told.Say("/sys/fs/cgroup/memory.swap.current", "0\n");
  EXPECT_EQ(told.Free(), 1.9e9);
  told.Say("/sys/fs/cgroup/memory.swap.max", "max\n");
  EXPECT_EQ(told.Free(), 1.4e9 + Swap);
}

TEST(MemoryDemand, TheTightestGroupAboveCounts)
{
  const Told told("memory-nested");
  told.Say("/proc/self/cgroup", "0::/batch/job\n");
  told.Say("/sys/fs/cgroup/batch/job/memory.max", "9000000000\n");
  told.Say("/sys/fs/cgroup/batch/job/memory.current", "0\n");
  told.Say("/sys/fs/cgroup/batch/memory.max", "3000000000\n");
  told.Say("/sys/fs/cgroup/batch/memory.current", "1000000000\n");
  EXPECT_EQ(told.Free(), 2.0e9);
}

TEST(MemoryDemand, ContainerOfControlGroupsOne)
{
  const Told told("memory-one");
  told.Say("/proc/self/cgroup", "5:cpu,cpuacct:/docker/abc\n4:memory:/docker/abc\n");
  told.Say("/sys/fs/cgroup/memory/memory.limit_in_bytes", "1000000000\n");
  told.Say("/sys/fs/cgroup/memory/memory.usage_in_bytes", "400000000\n");
  told.Say("/sys/fs/cgroup/memory/memory.stat", "total_inactive_file 50000000\n");
  EXPECT_EQ(told.Free(), 6.5e8);
}

// Ten percent more than the free memory of the machine; the field itself is small.
TEST(MemoryDemand, FilterRefusesBeforeItSearches)
{
  constexpr int azimuths = 3600;
  const double side = std::sqrt(1.1 * FreeMemory() / (sizeof(float) * azimuths));
  if (!(side < 10000.0))
  {
    GTEST_SKIP() << "the system does not tell its memory, or has terabytes of it";
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(side) + 2, static_cast<int>(side) + 2, 1);
  vtkNew<vtkUnsignedCharArray> heights;
  heights->SetNumberOfTuples(image->GetNumberOfPoints());
  heights->FillValue(7);
  image->GetPointData()->SetScalars(heights);
  vtkNew<vtkHeightFieldHorizon> filter;
  filter->SetInputData(image);
  filter->SetNumberOfAzimuths(azimuths);
  vtkNew<ErrorCatcher> errors;
  errors->Watch(filter);
  filter->Update();
  EXPECT_NE(errors->Text.find("GB are free; ask for less"), std::string::npos) << errors->Text;
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

} // namespace
} // namespace testing
} // namespace skyline
