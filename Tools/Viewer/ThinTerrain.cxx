// SPDX-License-Identifier: BSD-3-Clause
#include "ThinTerrain.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>

namespace skyline
{

vtkSmartPointer<vtkImageData> ThinTerrain(vtkImageData* terrain, double posts)
{
  const int step = static_cast<int>(
    std::ceil(std::sqrt(static_cast<double>(terrain->GetNumberOfPoints()) / posts)));
  const int* size = terrain->GetDimensions();
  const int columns = (size[0] - 1) / step + 1;
  const int rows = (size[1] - 1) / step + 1;
  auto thin = vtkSmartPointer<vtkImageData>::New();
  thin->SetDimensions(columns, rows, 1);
  thin->SetOrigin(terrain->GetOrigin());
  thin->SetSpacing(step * terrain->GetSpacing()[0], step * terrain->GetSpacing()[1], 1.0);
  vtkDataArray* from = terrain->GetPointData()->GetArray("Elevation");
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Elevation");
  heights->SetNumberOfTuples(static_cast<vtkIdType>(columns) * rows);
  vtkIdType post = 0;
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column, ++post)
    {
      const vtkIdType source = static_cast<vtkIdType>(row) * step * size[0] + column * step;
      heights->SetValue(post, static_cast<float>(from->GetComponent(source, 0)));
    }
  }
  thin->GetPointData()->SetScalars(heights);
  return thin;
}

} // namespace skyline
