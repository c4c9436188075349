// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldHorizon.h"

#include "Azimuths.h"
#include "Horizon/StoreAccumulator.h"
#include "HorizonScene.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHeightFieldHorizon);

void vtkHeightFieldHorizon::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfAzimuths: " << this->NumberOfAzimuths << "\n";
}

bool vtkHeightFieldHorizon::Compute(skyline::HorizonScene& scene, vtkImageData* output)
{
  const std::vector<double> azimuths = skyline::EvenAzimuths(this->NumberOfAzimuths);
  scene.DemandFloats("horizons", this->NumberOfAzimuths, azimuths);
  vtkFloatArray* horizon = scene.AddArray(output, "HorizonElevation", this->NumberOfAzimuths);
  if (!this->Store(scene, azimuths, horizon->GetPointer(0)))
  {
    return false;
  }
  scene.BlankMissing(horizon);
  return true;
}

bool vtkHeightFieldHorizon::Store(
  skyline::HorizonScene& scene, const std::vector<double>& azimuths, float* values)
{
  skyline::StoreAccumulator store(scene.Posts().Columns, values, this->NumberOfAzimuths);
  return scene.Run(azimuths, 0.0, store, skyline::AzimuthAxes::Image);
}
