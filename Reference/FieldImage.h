// SPDX-License-Identifier: BSD-3-Clause
// VTK images of the oracle's fields, and the arrays that filters make of them.
#ifndef skyline_FieldImage_h
#define skyline_FieldImage_h

#include "Reference/Oracle.h"
#include "Reference/Shapes.h"

#include "vtkAlgorithm.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

namespace skyline
{
namespace testing
{

template <typename Array>
vtkSmartPointer<vtkImageData> ImageOf(const oracle::OracleField& field, double shift = 0.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(field.Columns), static_cast<int>(field.Rows), 1);
  image->SetSpacing(field.SpacingX, field.SpacingY, 1.0);
  vtkNew<Array> heights;
  heights->SetName("Elevation");
  heights->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType post = 0; post < image->GetNumberOfPoints(); ++post)
  {
    heights->SetComponent(post, 0, field.Heights[static_cast<std::size_t>(post)] + shift);
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

inline vtkFloatArray* ArrayOf(vtkAlgorithm* filter, const char* name)
{
  auto* image = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  return vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(name));
}

} // namespace testing
} // namespace skyline

#endif
