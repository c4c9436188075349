// SPDX-License-Identifier: BSD-3-Clause
// What the machine cannot hold is refused before any work, by its bytes and with a cure.
#include "FilterTesting.h"
#include "MemoryDemand.h"

#include "vtkHeightFieldHorizon.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

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
      "horizons of 40000 x 40000 posts take 236.8 GB more (148 bytes a post) and 17.0 GB are free; "
      "ask for less at a time, cut the raster (gdal_translate -srcwin) or make it coarser (-tr)");
  }
}

TEST(MemoryDemand, TakesWhatFits)
{
  DemandMemory("horizons", 40000, 40000, 8.0, 12.8e9);
  DemandMemory("horizons", 40000, 40000, 1.0e6, std::numeric_limits<double>::infinity());
  EXPECT_GT(FreeMemory(), 0.0);
}

// A tenth more than what is free, whatever machine this is; the field itself is small.
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
