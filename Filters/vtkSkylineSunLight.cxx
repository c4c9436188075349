// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineSunLight.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSkylineSunLight);

void vtkSkylineSunLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Azimuth: " << this->Azimuth << "\n"
     << indent << "Elevation: " << this->Elevation << "\n"
     << indent << "AngularRadius: " << this->AngularRadius << "\n"
     << indent << "TrueRadius: " << this->TrueRadius << "\n"
     << indent << "Irradiance: " << this->Irradiance[0] << " " << this->Irradiance[1] << " "
     << this->Irradiance[2] << "\n"
     << indent << "UseTime: " << this->UseTime << "\n"
     << indent << "Time: " << this->Time << "\n"
     << indent << "LimbDarkening: " << this->LimbDarkening << "\n";
}
