// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldSkyView.h"

#include "Azimuths.h"
#include "HorizonScene.h"
#include "SkyAccumulator.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <memory>
#include <vector>

vtkStandardNewMacro(vtkHeightFieldSkyView);

void vtkHeightFieldSkyView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfAzimuths: " << this->NumberOfAzimuths << "\n"
     << indent << "SkyViewFactor: " << this->SkyViewFactor << "\n"
     << indent << "SkyViewFactorHorizontal: " << this->SkyViewFactorHorizontal << "\n"
     << indent << "VisibleSkyFraction: " << this->VisibleSkyFraction << "\n"
     << indent << "PositiveOpenness: " << this->PositiveOpenness << "\n";
}

bool vtkHeightFieldSkyView::Compute(skyline::HorizonScene& scene, vtkImageData* output)
{
  const std::vector<double> azimuths = skyline::EvenAzimuths(this->NumberOfAzimuths);
  const int quantities = this->SkyViewFactor + this->SkyViewFactorHorizontal +
    this->VisibleSkyFraction + this->PositiveOpenness;
  scene.DemandFloats("views of the sky", quantities + (this->SkyViewFactor ? 2 : 0), azimuths);
  std::vector<vtkFloatArray*> arrays;
  const auto buffer = [&](bool wanted, const char* name)
  {
    if (!wanted)
    {
      return skyline::PostBuffer();
    }
    arrays.push_back(scene.AddArray(output, name));
    return skyline::PostBuffer{ arrays.back()->GetPointer(0), 1 };
  };
  skyline::SkyBuffers buffers;
  buffers.SkyViewFactor = buffer(this->SkyViewFactor, "SkyViewFactor");
  buffers.SkyViewFactorHorizontal =
    buffer(this->SkyViewFactorHorizontal, "SkyViewFactorHorizontal");
  buffers.VisibleSkyFraction = buffer(this->VisibleSkyFraction, "VisibleSkyFraction");
  buffers.PositiveOpenness = buffer(this->PositiveOpenness, "PositiveOpenness");
  if (arrays.empty())
  {
    throw std::invalid_argument("no quantity is switched on; switch on SkyViewFactor or another");
  }

  // Only the tilted surface needs its plane.
  std::unique_ptr<float[]> gradients;
  const auto posts = static_cast<std::size_t>(output->GetNumberOfPoints());
  float* north = nullptr;
  if (this->SkyViewFactor)
  {
    gradients.reset(new float[2 * posts]);
    north = gradients.get() + posts;
    scene.FillGradients(gradients.get(), north);
  }
  skyline::SkyAccumulator sky(scene.Posts().Columns, buffers, gradients.get(), north);
  if (!scene.Run(azimuths, 2.0 * skyline::Pi / this->NumberOfAzimuths, sky))
  {
    return false;
  }
  for (vtkFloatArray* array : arrays)
  {
    scene.BlankMissing(array);
  }
  return true;
}
