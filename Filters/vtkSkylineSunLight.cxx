// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineSunLight.h"

#include "BaseHeight.h"
#include "SunField.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSkylineGeoreference.h"

#include <exception>

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

bool vtkSkylineSunLight::FindDirection(vtkImageData* heightField, double direction[3])
{
  direction[0] = this->Azimuth;
  direction[1] = this->Elevation;
  direction[2] = this->AngularRadius;
  if (!this->UseTime)
  {
    return true;
  }
  if (!heightField)
  {
    vtkErrorMacro("no height field: the sun of a time needs a place");
    return false;
  }
  double range[2] = { 0.0, 0.0 };
  double height = 0.0;
  if (vtkDataArray* heights = heightField->GetPointData()->GetScalars())
  {
    heights->GetFiniteRange(range, 0);
    if (range[0] <= range[1])
    {
      height = skyline::BaseHeight(heights->GetNumberOfTuples(), range[0], range[1],
        [&](std::ptrdiff_t post) { return heights->GetComponent(post, 0); });
    }
  }
  const int* posts = heightField->GetDimensions();
  try
  {
    const skyline::SunField sun(
      skyline::LoadGeoreference(heightField), skyline::ParseUtcTime(this->Time), height);
    const skyline::GridSun middle = sun.At(0.5 * (posts[0] - 1), 0.5 * (posts[1] - 1));
    direction[0] = middle.Azimuth;
    direction[1] = middle.Elevation;
    if (this->TrueRadius)
    {
      direction[2] = middle.Radius;
    }
    return true;
  }
  catch (const std::exception& reason)
  {
    vtkErrorMacro(<< reason.what());
    return false;
  }
}
