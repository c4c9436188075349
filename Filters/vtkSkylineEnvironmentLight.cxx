// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineEnvironmentLight.h"

#include "Data/LightMapImage.h"
#include "Shared/Constants.h"
#include "Sky/LightTable.h"
#include "Sky/SkyDescription.h"
#include "Sky/SkyModel.h"
#include "Sky/ZonalSky.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSkylineEnvironmentLight);

vtkSkylineEnvironmentLight::vtkSkylineEnvironmentLight() = default;
vtkSkylineEnvironmentLight::~vtkSkylineEnvironmentLight() = default;

void vtkSkylineEnvironmentLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Source: " << this->Source << "\n"
     << indent << "Radiance: " << this->Radiance[0] << " " << this->Radiance[1] << " "
     << this->Radiance[2] << "\n"
     << indent << "Image: " << this->Image.GetPointer() << "\n"
     << indent << "Rotation: " << this->Rotation << "\n"
     << indent << "CieType: " << this->CieType << "\n"
     << indent << "DirectIrradiance: " << this->DirectIrradiance << "\n"
     << indent << "DiffuseIrradiance: " << this->DiffuseIrradiance << "\n"
     << indent << "SunAzimuth: " << this->SunAzimuth << "\n"
     << indent << "SunElevation: " << this->SunElevation << "\n";
}

bool vtkSkylineEnvironmentLight::SetSky(const char* text)
{
  try
  {
    return this->SetSky(skyline::ParseSky(text ? text : ""));
  }
  catch (const std::invalid_argument& reason)
  {
    vtkErrorMacro(<< reason.what());
    return false;
  }
}

bool vtkSkylineEnvironmentLight::SetSky(const skyline::SkyDescription& sky)
{
  switch (sky.Kind)
  {
    case skyline::SkyKind::Map:
      return false;
    case skyline::SkyKind::Perez:
      this->SetSourceToPerez();
      this->SetDirectIrradiance(sky.DirectIrradiance);
      this->SetDiffuseIrradiance(sky.DiffuseIrradiance);
      break;
    case skyline::SkyKind::Zonal:
    case skyline::SkyKind::Formula:
      this->SetSourceToCie();
      this->SetCieType(sky.CieType);
      break;
    case skyline::SkyKind::Uniform:
      this->SetSourceToUniform();
      break;
    case skyline::SkyKind::None:
      this->SwitchOff();
      break;
  }
  return true;
}

bool vtkSkylineEnvironmentLight::IsSameAllAround()
{
  return this->Source == UNIFORM ||
    (this->Source == CIE && skyline::ZonalSky::Knows(this->CieType));
}

void vtkSkylineEnvironmentLight::SetImage(vtkImageData* image)
{
  if (this->Image != image || this->Source != IMAGE)
  {
    this->Image = image;
    this->Source = IMAGE;
    this->Modified();
  }
}

vtkImageData* vtkSkylineEnvironmentLight::GetImage()
{
  return this->Image;
}

vtkMTimeType vtkSkylineEnvironmentLight::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Image ? std::max(own, this->Image->GetMTime()) : own;
}

void vtkSkylineEnvironmentLight::FillPixels()
{
  using namespace skyline;
  this->PixelsAreImage = false;
  if (this->Source == IMAGE)
  {
    const LightMap map = ViewLightMap(this->Image);
    const auto fine = [](float value) { return value >= 0.0f && std::isfinite(value); };
    const float* first = map.Pixel(map.Rows - 1, 0); // image rows start at the bottom
    const auto count = static_cast<std::size_t>(3 * map.Columns * map.Rows);
    this->PixelsAreImage = std::all_of(first, first + count, fine);
    if (!this->PixelsAreImage)
    {
      this->Pixels.assign(first, first + count);
      SanitizeLightMap(this->Pixels.data(), map.Columns * map.Rows);
    }
    return;
  }
  if (this->Source == UNIFORM)
  {
    this->Pixels.assign(3 * 2, 1.0f);
    return;
  }
  const double elevation = this->SunElevation * RadiansPerDegree;
  const bool perez = this->Source == PEREZ;
  this->Pixels.resize(3 * static_cast<std::size_t>(SkyWidth) * SkyHeight);
  if (perez && elevation <= 0.0)
  {
    std::fill(this->Pixels.begin(), this->Pixels.end(), 0.0f); // the sun is not above the horizon
    return;
  }
  const SkyModel sky = perez ? PerezSky(this->DirectIrradiance, this->DiffuseIrradiance, elevation)
                             : CieSky(this->CieType);
  FillSky(sky, std::fmod(this->SunAzimuth, 360.0) * RadiansPerDegree, elevation,
    { perez, perez ? this->DiffuseIrradiance : 1.0 }, SkyWidth, SkyHeight, this->Pixels.data());
}

skyline::TurnedLightMap vtkSkylineEnvironmentLight::GetLightMap()
{
  using namespace skyline;
  if (!std::isfinite(this->Rotation))
  {
    throw std::invalid_argument(
      "the rotation of the environment is not a finite number; give degrees");
  }
  for (const double factor : this->Radiance)
  {
    if (!(factor >= 0.0 && std::isfinite(factor)))
    {
      throw std::invalid_argument("an environment's radiance is below 0 or not finite: " +
        std::to_string(factor) + "; give 0 or more");
    }
  }
  if (this->PixelTime < this->GetMTime())
  {
    this->FillPixels();
    this->PixelTime = this->GetMTime();
  }
  TurnedLightMap light;
  light.Rotation = std::fmod(this->Rotation, 360.0) * RadiansPerDegree; // fmod is exact
  std::copy_n(this->Radiance, 3, light.Scale);
  if (this->Source == IMAGE)
  {
    const LightMap map = ViewLightMap(this->Image);
    light.Map =
      this->PixelsAreImage ? map : ViewBottomUp(this->Pixels.data(), map.Columns, map.Rows);
  }
  else if (this->Source == UNIFORM)
  {
    light.Map = ViewTopDown(this->Pixels.data(), 1, 2);
  }
  else
  {
    light.Map = ViewTopDown(this->Pixels.data(), SkyWidth, SkyHeight);
  }
  return light;
}
