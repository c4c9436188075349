// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineLampLight.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSkylineLampLight);

void vtkSkylineLampLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto triple = [&](const char* name, const double* v)
  { os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  triple("Position", this->Position);
  os << indent << "Radius: " << this->Radius << "\n";
  triple("Radiance", this->Radiance);
}
