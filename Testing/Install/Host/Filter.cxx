// SPDX-License-Identifier: BSD-3-Clause
// Level ground has a level horizon wherever there is more ground.
#include "vtkFloatArray.h"
#include "vtkHeightFieldHorizon.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cstdio>

int main()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->Fill(100.0);

  vtkNew<vtkHeightFieldHorizon> horizon;
  horizon->SetNumberOfAzimuths(4);
  horizon->SetInputData(image);
  horizon->Update();
  vtkDataArray* result = horizon->GetOutput()->GetPointData()->GetArray("HorizonElevation");
  const double* north = result ? result->GetTuple(2) : nullptr; // of a post of the south edge
  const bool level = north && north[0] == 0.0 && north[2] == -90.0;
  std::puts(level ? "a level horizon" : "no level horizon");
  return level ? 0 : 1;
}
