// SPDX-License-Identifier: BSD-3-Clause
#include "PostValues.h"

#include "Data/ImageGeoreference.h"
#include "HeightField/Normals.h"
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
  const int* size = image->GetDimensions();
  const Grid grid{ size[0], size[1], image->GetSpacing()[0], image->GetSpacing()[1] };
  const Georeference place = LoadGeoreference(image);
  const auto rows = static_cast<std::size_t>(size[1]);
  const bool own = place.RowSpacingX.size() == rows && place.RowSpacingY.size() == rows;
  const auto posts = static_cast<std::size_t>(image->GetNumberOfPoints());
  std::vector<float> east(posts);
  std::vector<float> north(posts);
  Gradients(
    grid,
    [&](std::ptrdiff_t column, std::ptrdiff_t row)
    { return heights->GetComponent(row * grid.Columns + column, 0); },
    0, grid.Rows, east.data(), north.data(), own ? place.RowSpacingX.data() : nullptr,
    own ? place.RowSpacingY.data() : nullptr);
  std::vector<float> both(2 * posts);
  for (std::size_t post = 0; post < posts; ++post)
  {
    both[2 * post] = east[post];
    both[2 * post + 1] = north[post];
  }
  FillMissing(both, static_cast<std::size_t>(size[0]), rows, 2);
  return both;
}

} // namespace skyline
