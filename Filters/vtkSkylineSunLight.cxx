// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineSunLight.h"

#include "Data/ImageGeoreference.h"
#include "HeightArray.h"
#include "PlacedSun.h"
#include "Shared/Constants.h"
#include "Sun/SunPosition.h"
#include "Sun/UtcTime.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <exception>

vtkStandardNewMacro(vtkSkylineSunLight);

std::string vtkSkylineSunLight::FindTimeError(const std::string& text)
{
  try
  {
    const skyline::SunEphemeris years(skyline::ParseUtcTime(text)); // throws for years out of range
    return "";
  }
  catch (const std::exception& reason)
  {
    return reason.what();
  }
}

bool vtkSkylineSunLight::NamesZone(const std::string& text)
{
  return skyline::NamesZone(text);
}

double vtkSkylineSunLight::GetLargestRadius()
{
  return skyline::LargestSunRadius;
}

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
     << indent << "HoursLater: " << this->HoursLater << "\n"
     << indent << "LimbDarkening: " << this->LimbDarkening << "\n";
}

namespace
{

double BaseHeightOf(vtkImageData* heightField)
{
  vtkDataArray* heights = heightField->GetPointData()->GetScalars();
  return heights ? skyline::BaseHeightOf(heights) : 0.0;
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
    vtkErrorMacro("no height field: the sun at a time needs a place; give a height field");
    return false;
  }
  try
  {
    const skyline::Georeference place = skyline::GeoreferenceOf(heightField);
    const skyline::SunField sun = skyline::SunFieldOf(this, place, BaseHeightOf(heightField));
    const skyline::GridSun middle = skyline::InTheMiddle(sun, place);
    direction[0] = middle.Azimuth;
    direction[1] = middle.Elevation;
    direction[2] = skyline::RadiusOf(this, sun);
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
  try
  {
    const skyline::Georeference place = skyline::GeoreferenceOf(heightField);
    const skyline::EclipseField field =
      skyline::EclipseFieldOf(this, place, BaseHeightOf(heightField));
    if (field.Any())
    {
      const skyline::SunAndMoon middle = skyline::InTheMiddle(field, place);
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
