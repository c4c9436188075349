// SPDX-License-Identifier: BSD-3-Clause
#include "SceneImage.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <limits>

namespace skyline
{
namespace benchmark
{

vtkSmartPointer<vtkImageData> ImageOf(const oracle::OracleField& field)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(field.Columns), static_cast<int>(field.Rows), 1);
  image->SetSpacing(field.SpacingX, field.SpacingY, 1.0);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Elevation");
  heights->SetNumberOfTuples(image->GetNumberOfPoints());
  image->GetPointData()->SetScalars(heights);
  SetHeights(image, field);
  return image;
}

void SetHeights(vtkImageData* image, const oracle::OracleField& field)
{
  auto* heights = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType post = 0; post < heights->GetNumberOfTuples(); ++post)
  {
    heights->SetValue(post, static_cast<float>(field.Heights[static_cast<std::size_t>(post)]));
  }
  Touch(image);
}

void Touch(vtkImageData* image)
{
  auto* heights = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType post = 0; post < heights->GetNumberOfTuples(); ++post)
  {
    const float height = heights->GetValue(post);
    if (std::isfinite(height))
    {
      heights->SetValue(post, std::nextafter(height, std::numeric_limits<float>::infinity()));
      break;
    }
  }
  heights->Modified();
  image->Modified();
}

} // namespace benchmark
} // namespace skyline
