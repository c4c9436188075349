// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineKeyLight.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSkylineKeyLight);

void vtkSkylineKeyLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Azimuth: " << this->Azimuth << "\n"
     << indent << "Elevation: " << this->Elevation << "\n"
     << indent << "AngularRadius: " << this->AngularRadius << "\n"
     << indent << "Radiance: " << this->Radiance[0] << " " << this->Radiance[1] << " "
     << this->Radiance[2] << "\n";
}
