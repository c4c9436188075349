// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineLight.h"

void vtkSkylineLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Switch: " << this->Switch << "\n";
}
