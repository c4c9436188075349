// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldSkyLight.h"

#include "Azimuths.h"
#include "HorizonDriver.h"
#include "PostArrays.h"
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

bool vtkHeightFieldSkyLight::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  const std::vector<double> azimuths = skyline::EvenAzimuths(this->NumberOfAzimuths);
  const skyline::ZonalSky sky(this->CieType);
  const auto posts = static_cast<std::size_t>(output->GetNumberOfPoints());
  const std::unique_ptr<float[]> gradients(new float[2 * posts]);
  driver.Input().FillGradients(gradients.get(), gradients.get() + posts);
  vtkFloatArray* light = skyline::AddPostArray(output, "SkyLight");
  skyline::ZonalSkyAccumulator sum(sky, driver.Input().Posts().Columns, gradients.get(),
    gradients.get() + posts, light->GetPointer(0));
  if (!driver.Run(azimuths, 2.0 * skyline::Pi / this->NumberOfAzimuths, sum))
  {
    return false;
  }
  skyline::BlankMissing(driver.Input().Field(), light);
  return true;
}
