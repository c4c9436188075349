// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVHeightFieldIrradiance.h"

#include "Data/ErrorReason.h"
#include "LightPasses.h"
#include "Shared/Constants.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineLampLight.h"
#include "vtkSkylineLightMapReader.h"
#include "vtkSkylineSunLight.h"
#include "vtkSmartPointer.h"

#include <stdexcept>

vtkStandardNewMacro(vtkPVHeightFieldIrradiance);

vtkPVHeightFieldIrradiance::vtkPVHeightFieldIrradiance()
{
  this->AddLight(this->SunLight);
  this->AddLight(this->SkyLight);
}

vtkPVHeightFieldIrradiance::~vtkPVHeightFieldIrradiance() = default;

void vtkPVHeightFieldIrradiance::SetSunAzimuth(double degrees)
{
  this->SunLight->SetAzimuth(degrees);
}

void vtkPVHeightFieldIrradiance::SetSunElevation(double degrees)
{
  this->SunLight->SetElevation(degrees);
}

void vtkPVHeightFieldIrradiance::SetSunAngularRadius(double degrees)
{
  this->SunLight->SetAngularRadius(degrees);
}

void vtkPVHeightFieldIrradiance::SetSunIrradiance(double red, double green, double blue)
{
  this->SunLight->SetIrradiance(red, green, blue);
}

void vtkPVHeightFieldIrradiance::SetSunTime(const char* time)
{
  this->SunLight->SetTime(time);
}

void vtkPVHeightFieldIrradiance::SetHoursLater(double hours)
{
  this->SunLight->SetHoursLater(hours);
}

void vtkPVHeightFieldIrradiance::SetLimbDarkening(bool on)
{
  this->SunLight->SetLimbDarkening(on);
}

void vtkPVHeightFieldIrradiance::SetSkyRadiance(double red, double green, double blue)
{
  this->SkyLight->SetRadiance(red, green, blue);
}

void vtkPVHeightFieldIrradiance::SetCieType(int type)
{
  this->SkyLight->SetCieType(type);
}

void vtkPVHeightFieldIrradiance::SetDirectIrradiance(double irradiance)
{
  this->SkyLight->SetDirectIrradiance(irradiance);
}

void vtkPVHeightFieldIrradiance::SetDiffuseIrradiance(double irradiance)
{
  this->SkyLight->SetDiffuseIrradiance(irradiance);
}

void vtkPVHeightFieldIrradiance::AddLamp(
  double x, double y, double z, double radius, double red, double green, double blue)
{
  const auto lamp = vtkSmartPointer<vtkSkylineLampLight>::New();
  lamp->SetPosition(x, y, z);
  lamp->SetRadius(radius);
  lamp->SetRadiance(red, green, blue);
  this->Lamps.push_back(lamp);
  this->AddLight(lamp);
}

void vtkPVHeightFieldIrradiance::RemoveAllLamps()
{
  for (const auto& lamp : this->Lamps)
  {
    this->RemoveLight(lamp);
  }
  this->Lamps.clear();
}

// Sets the direction of the sun. The CIE and Perez skies are brightest there, too.
void vtkPVHeightFieldIrradiance::PlaceSun(const skyline::HorizonDriver& driver)
{
  this->SunLight->SetSwitch(this->Sun != NO_SUN);
  this->SunLight->SetUseTime(this->Sun == SUN_BY_TIME);
  const skyline::SkyDisc disc = skyline::DiscOf(this->SunLight, driver);
  this->SkyLight->SetSunAzimuth(disc.Azimuth * skyline::DegreesPerRadian);
  this->SkyLight->SetSunElevation(disc.Elevation * skyline::DegreesPerRadian);
}

void vtkPVHeightFieldIrradiance::ReadEnvironment()
{
  if (this->EnvironmentFile == this->ReadFile && this->SkyLight->GetImage())
  {
    return;
  }
  if (this->EnvironmentFile.empty())
  {
    throw std::invalid_argument("the sky is a light map without a file: set Environment File");
  }
  std::string report;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&report);
  listener->SetCallback([](vtkObject*, unsigned long, void* text, void* line)
    { *static_cast<std::string*>(text) = static_cast<const char*>(line); });
  vtkNew<vtkSkylineLightMapReader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, listener);
  reader->SetFileName(this->EnvironmentFile.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0)
  {
    throw std::invalid_argument(skyline::ErrorReason(report));
  }
  this->SkyLight->SetImage(reader->GetOutput());
  this->ReadFile = this->EnvironmentFile;
}

bool vtkPVHeightFieldIrradiance::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  this->PlaceSun(driver);
  this->SkyLight->SetSwitch(this->Sky != NO_SKY);
  this->SkyLight->SetRotation(this->Sky == FILE_SKY ? this->Rotation : 0.0);
  if (this->Sky == FILE_SKY)
  {
    this->ReadEnvironment();
  }
  switch (this->Sky)
  {
    case FILE_SKY:
      this->SkyLight->SetSourceToImage();
      break;
    case CIE_SKY:
      this->SkyLight->SetSourceToCie();
      break;
    case PEREZ_SKY:
      this->SkyLight->SetSourceToPerez();
      break;
    default:
      this->SkyLight->SetSourceToUniform();
  }
  return this->Superclass::Compute(driver, output);
}

void vtkPVHeightFieldIrradiance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sun: " << this->Sun << "\n"
     << indent << "Sky: " << this->Sky << "\n"
     << indent << "EnvironmentFile: " << this->EnvironmentFile << "\n"
     << indent << "Rotation: " << this->Rotation << "\n"
     << indent << "Lamps: " << this->Lamps.size() << "\n"
     << indent << "SunLight:\n";
  this->SunLight->PrintSelf(os, indent.GetNextIndent());
  os << indent << "SkyLight:\n";
  this->SkyLight->PrintSelf(os, indent.GetNextIndent());
}
