// SPDX-License-Identifier: BSD-3-Clause
// Fields for the filters on the graphics processor, and the difference of two arrays.
#ifndef skyline_GpuTesting_h
#define skyline_GpuTesting_h

#include "vtkOpenGLHeightFieldDevice.h"

#include "Testing/Filters/FilterTesting.h"

#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyline
{
namespace testing
{

/// The greatest difference of two arrays. It is infinite if their sizes or their missing values
/// differ.
inline double Difference(vtkFloatArray* a, vtkFloatArray* b)
{
  const double infinite = std::numeric_limits<double>::infinity();
  if (!a || !b || a->GetNumberOfValues() != b->GetNumberOfValues())
  {
    return infinite;
  }
  double greatest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
  {
    const double x = a->GetValue(i);
    const double y = b->GetValue(i);
    if (std::isnan(x) != std::isnan(y))
    {
      return infinite;
    }
    greatest = std::isnan(x) ? greatest : std::max(greatest, std::abs(x - y));
  }
  return greatest;
}

inline oracle::OracleField Hills(std::ptrdiff_t columns, std::ptrdiff_t rows)
{
  return shapes::Fractal(columns, rows, 30.0, 1500.0, 7);
}

/// Hills with missing areas.
inline oracle::OracleField HillsWithHoles(std::ptrdiff_t columns, std::ptrdiff_t rows)
{
  oracle::OracleField field = Hills(columns, rows);
  shapes::RemoveIslands(field, 5, 4, 3);
  return field;
}

/// The base of all tests that use the graphics processor. It skips the test if there is no context.
class GpuTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (!this->Device->IsAvailable())
    {
      GTEST_SKIP() << "no OpenGL context: " << this->Device->GetReason();
    }
  }

  vtkNew<vtkOpenGLHeightFieldDevice> Device;
};

} // namespace testing
} // namespace skyline

#endif
