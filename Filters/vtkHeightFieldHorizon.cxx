// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldHorizon.h"

#include "Azimuths.h"
#include "Horizon/StoreAccumulator.h"
#include "HorizonDriver.h"
#include "PostArrays.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHeightFieldHorizon);

void vtkHeightFieldHorizon::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfAzimuths: " << this->NumberOfAzimuths << "\n";
}

bool vtkHeightFieldHorizon::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  const std::vector<double> azimuths = skyline::EvenAzimuths(this->NumberOfAzimuths);
  driver.DemandFloats("horizons", this->NumberOfAzimuths, azimuths);
  vtkFloatArray* horizon =
    skyline::AddPostArray(output, "HorizonElevation", this->NumberOfAzimuths);
  if (!this->Store(driver, azimuths, horizon->GetPointer(0)))
  {
    return false;
  }
  skyline::BlankMissing(driver.Input().Field(), horizon);
  return true;
}

bool vtkHeightFieldHorizon::Store(
  skyline::HorizonDriver& driver, const std::vector<double>& azimuths, float* values)
{
  skyline::StoreAccumulator store(driver.Input().Posts().Columns, values, this->NumberOfAzimuths);
  return driver.Run(azimuths, 0.0, store, skyline::AzimuthAxes::Image);
}
