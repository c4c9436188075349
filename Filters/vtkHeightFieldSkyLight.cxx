// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldSkyLight.h"

#include "Azimuths.h"
#include "HorizonScene.h"
#include "Sky/ZonalSky.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <memory>
#include <vector>

vtkStandardNewMacro(vtkHeightFieldSkyLight);

void vtkHeightFieldSkyLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfAzimuths: " << this->NumberOfAzimuths << "\n"
     << indent << "CieType: " << this->CieType << "\n";
}

bool vtkHeightFieldSkyLight::Compute(skyline::HorizonScene& scene, vtkImageData* output)
{
  const std::vector<double> azimuths = skyline::EvenAzimuths(this->NumberOfAzimuths);
  const skyline::ZonalSky sky(this->CieType);
  const auto posts = static_cast<std::size_t>(output->GetNumberOfPoints());
  const std::unique_ptr<float[]> gradients(new float[2 * posts]);
  scene.FillGradients(gradients.get(), gradients.get() + posts);
  vtkFloatArray* light = scene.AddArray(output, "SkyLight");
  skyline::ZonalSkyAccumulator sum(
    sky, scene.Posts().Columns, gradients.get(), gradients.get() + posts, light->GetPointer(0));
  if (!scene.Run(azimuths, 2.0 * skyline::Pi / this->NumberOfAzimuths, sum))
  {
    return false;
  }
  scene.BlankMissing(light);
  return true;
}
