// SPDX-License-Identifier: BSD-3-Clause
#include "HeightArray.h"

#include "Data/MemoryDemand.h"
#include "HeightField/BaseHeight.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"

#include <algorithm>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>

namespace skyline
{

void CheckSurface(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  if (size[2] != 1 || size[0] < 2 || size[1] < 2)
  {
    throw std::invalid_argument("no surface: " + std::to_string(size[0]) + " x " +
      std::to_string(size[1]) + " x " + std::to_string(size[2]) +
      " posts; a height field has at least 2 x 2 x 1");
  }
}

void CheckHeights(vtkImageData* image, vtkDataArray* heights)
{
  if (heights == nullptr || heights->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    throw std::invalid_argument(
      "the input has no heights: choose its array by SetInputArrayToProcess");
  }
  if (heights->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("the heights have " +
      std::to_string(heights->GetNumberOfComponents()) + " components; give one per post");
  }
}

std::string ReasonOfFailure(vtkImageData* image, const std::function<void()>& work)
{
  try
  {
    work();
    return "";
  }
  catch (const std::bad_alloc&)
  {
    const int* posts = image->GetDimensions();
    return "not enough memory for " + std::to_string(posts[0]) + " x " + std::to_string(posts[1]) +
      " posts (std::bad_alloc); " + MemoryAdvice;
  }
  catch (const std::exception& reason)
  {
    return reason.what();
  }
}

double BaseHeightOf(vtkDataArray* heights)
{
  double range[2];
  heights->GetFiniteRange(range, 0);
  return range[0] <= range[1]
    ? BaseHeight(heights->GetNumberOfTuples(), range[0], range[1],
        [heights](std::ptrdiff_t post) { return heights->GetComponent(post, 0); })
    : 0.0;
}

void ReadTuples(vtkDataArray* array, vtkIdType first, vtkIdType count, double* values)
{
  const auto worker = [&](auto* typed)
  {
    const int components = typed->GetNumberOfComponents();
    const auto range =
      vtk::DataArrayValueRange(typed, first * components, (first + count) * components);
    std::transform(
      range.cbegin(), range.cend(), values, [](auto value) { return static_cast<double>(value); });
  };
  if (!vtkArrayDispatch::Dispatch::Execute(array, worker))
  {
    worker(array);
  }
}

} // namespace skyline
