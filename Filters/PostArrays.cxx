// SPDX-License-Identifier: BSD-3-Clause
#include "PostArrays.h"

#include "Data/MemoryDemand.h"
#include "HeightField/HeightField.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace skyline
{

namespace
{

// Calls f(missing, values) for each post, row by row.
template <typename Function>
void ForEachPost(const HeightField& field, vtkFloatArray* array, const Function& f)
{
  const std::ptrdiff_t components = array->GetNumberOfComponents();
  float* post = array->GetPointer(0);
  std::vector<float> buffer;
  for (std::ptrdiff_t row = 0; row < field.Posts().Rows; ++row)
  {
    const float* heights = field.Receivers(false, row, buffer);
    for (std::ptrdiff_t column = 0; column < field.Posts().Columns; ++column, post += components)
    {
      f(heights[column] <= 0.5f * MissingHeight, post);
    }
  }
}

} // namespace

vtkFloatArray* AddPostArray(vtkImageData* output, const char* name, int components)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(output->GetNumberOfPoints());
  if (array->GetNumberOfTuples() != output->GetNumberOfPoints())
  {
    throw std::runtime_error(std::string("no memory for ") + name + ": " +
      std::to_string(output->GetNumberOfPoints()) + " posts of " + std::to_string(components) +
      " floats; " + MemoryAdvice);
  }
  output->GetPointData()->AddArray(array);
  return array;
}

void BlankMissing(const HeightField& field, vtkFloatArray* array)
{
  if (!field.HasMissing())
  {
    return;
  }
  const int components = array->GetNumberOfComponents();
  ForEachPost(field, array,
    [components](bool missing, float* post)
    {
      if (missing)
      {
        std::fill_n(post, components, std::numeric_limits<float>::quiet_NaN());
      }
    });
}

std::ptrdiff_t CountNotFinite(const HeightField& field, vtkFloatArray* array)
{
  const int components = array->GetNumberOfComponents();
  std::ptrdiff_t count = 0;
  ForEachPost(field, array,
    [&](bool missing, const float* post)
    {
      const bool finite =
        std::all_of(post, post + components, [](float value) { return std::isfinite(value); });
      count += finite || missing ? 0 : 1;
    });
  return count;
}

} // namespace skyline
