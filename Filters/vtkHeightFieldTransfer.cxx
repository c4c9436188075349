// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldTransfer.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHeightFieldTransfer);

bool vtkHeightFieldTransfer::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  return this->Project(driver, output, "TransferSH", true);
}

void vtkHeightFieldTransfer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
