// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineLampLight.h"

#include "Data/ImageGeoreference.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSkylineLampLight);

void vtkSkylineLampLight::SetMapPosition(vtkImageData* heightField, double x, double y, double z)
{
  const skyline::Georeference place = skyline::LoadGeoreference(heightField);
  if (heightField && place.HasGeoTransform)
  {
    // Converts from the map to posts, and from posts to the coordinates of the image.
    const auto& transform = place.GeoTransform;
    const double column = (x - transform[0]) / transform[1] - 0.5;
    const double down = (y - transform[3]) / transform[5] - 0.5;
    const double row = static_cast<double>(place.Rows - 1) - down;
    x = heightField->GetOrigin()[0] + column * heightField->GetSpacing()[0];
    y = heightField->GetOrigin()[1] + row * heightField->GetSpacing()[1];
  }
  this->SetPosition(x, y, z);
}

void vtkSkylineLampLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto triple = [&](const char* name, const double* v)
  { os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  triple("Position", this->Position);
  os << indent << "Radius: " << this->Radius << "\n";
  triple("Radiance", this->Radiance);
}
