// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineSunLight.h"

#include "Data/ImageGeoreference.h"
#include "HeightField/BaseHeight.h"
#include "Sun/Eclipse.h"
#include "Sun/SunField.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

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

namespace
{

double MiddleHeight(vtkImageData* heightField)
{
  vtkDataArray* heights = heightField->GetPointData()->GetScalars();
  double range[2] = { 0.0, -1.0 };
  if (heights)
  {
    heights->GetFiniteRange(range, 0);
  }
  return range[0] <= range[1]
    ? skyline::BaseHeight(heights->GetNumberOfTuples(), range[0], range[1],
        [&](std::ptrdiff_t post) { return heights->GetComponent(post, 0); })
    : 0.0;
}

} // namespace

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
  const double height = MiddleHeight(heightField);
  const int* posts = heightField->GetDimensions();
  try
  {
    const skyline::SunField sun(
      skyline::GeoreferenceOf(heightField), skyline::ParseUtcTime(this->Time), height);
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

bool vtkSkylineSunLight::FindEclipse(vtkImageData* heightField, double eclipse[2])
{
  eclipse[0] = eclipse[1] = 0.0;
  if (!this->UseTime || !heightField)
  {
    return true;
  }
  const int* posts = heightField->GetDimensions();
  try
  {
    const skyline::EclipseField field(skyline::GeoreferenceOf(heightField),
      skyline::ParseUtcTime(this->Time), MiddleHeight(heightField));
    if (field.Any())
    {
      const skyline::SunAndMoon middle = field.At(0.5 * (posts[0] - 1), 0.5 * (posts[1] - 1));
      eclipse[0] = middle.Magnitude();
      eclipse[1] = middle.Obscuration();
    }
    return true;
  }
  catch (const std::exception& reason)
  {
    vtkErrorMacro(<< reason.what());
    return false;
  }
}
