// SPDX-License-Identifier: BSD-3-Clause
#include "PostValues.h"

#include "HorizonInput.h"
#include "PostTexture.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <cstddef>

namespace skyline
{

std::vector<float> PostValues(vtkDataArray* array, int first, int count, int columns, int rows)
{
  const vtkIdType posts = array->GetNumberOfTuples();
  std::vector<float> values(static_cast<std::size_t>(posts * count));
  auto to = values.begin();
  for (vtkIdType post = 0; post < posts; ++post)
  {
    for (int c = first; c < first + count; ++c)
    {
      *to++ = static_cast<float>(array->GetComponent(post, c));
    }
  }
  FillMissing(values, static_cast<std::size_t>(columns), static_cast<std::size_t>(rows),
    static_cast<std::size_t>(count));
  return values;
}

std::vector<float> PostGradients(vtkImageData* image, vtkDataArray* heights)
{
  const HorizonInput input(image, heights);
  const Grid& grid = input.Posts();
  const auto posts = static_cast<std::size_t>(image->GetNumberOfPoints());
  std::vector<float> east(posts);
  std::vector<float> north(posts);
  input.FillGradients(east.data(), north.data());
  std::vector<float> both(2 * posts);
  for (std::size_t post = 0; post < posts; ++post)
  {
    both[2 * post] = east[post];
    both[2 * post + 1] = north[post];
  }
  FillMissing(both, static_cast<std::size_t>(grid.Columns), static_cast<std::size_t>(grid.Rows), 2);
  return both;
}

} // namespace skyline
