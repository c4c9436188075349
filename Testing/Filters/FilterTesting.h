// SPDX-License-Identifier: BSD-3-Clause
// VTK images from the oracle's fields, and the errors that filters report.
#ifndef skyline_FilterTesting_h
#define skyline_FilterTesting_h

#include "Oracle.h"
#include "Shapes.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

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

/// Collects the error messages of an algorithm and its executive.
class ErrorCatcher : public vtkCommand
{
public:
  static ErrorCatcher* New() { return new ErrorCatcher; }
  void Execute(vtkObject*, unsigned long, void* text) override
  {
    this->Text += static_cast<const char*>(text);
    ++this->Count;
  }
  void Watch(vtkAlgorithm* algorithm) { algorithm->AddObserver(vtkCommand::ErrorEvent, this); }
  std::string Text;
  int Count = 0;
};

} // namespace testing
} // namespace skyline

#endif
