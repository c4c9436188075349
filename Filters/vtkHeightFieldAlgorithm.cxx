// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldAlgorithm.h"

#include "Data/Warnings.h"
#include "HeightArray.h"
#include "HorizonDriver.h"
#include "PyramidCache.h"
#include "Shared/Constants.h"
#include "WholeField.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkVersionMacros.h"

#include <stdexcept>
#include <string>

namespace
{

// Near hot ground, k down to about -5 was measured. Far below -100 all terrain would disappear.
constexpr double LeastRefraction = -100.0;

} // namespace

vtkHeightFieldAlgorithm::vtkHeightFieldAlgorithm()
  : RefractionCoefficient(skyline::TerrestrialRefraction)
  , Pyramids(std::make_unique<skyline::PyramidCache>())
{
}

vtkHeightFieldAlgorithm::~vtkHeightFieldAlgorithm() = default;

void vtkHeightFieldAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n"
     << indent << "Surface: " << this->Surface << "\n"
     << indent << "Flat: " << this->Flat << "\n"
     << indent << "RefractionCoefficient: " << this->RefractionCoefficient << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "LevelStep: " << this->LevelStep << "\n"
     << indent << "LevelOffset: " << this->LevelOffset << "\n"
     << indent << "LevelDistance: " << this->LevelDistance << "\n"
     << indent << "LevelSpline: " << this->LevelSpline << "\n"
     << indent << "PrepareSeconds: " << this->PrepareSeconds << "\n"
     << indent << "SearchSeconds: " << this->SearchSeconds << "\n"
     << indent << "PyramidBuilds: " << this->PyramidBuilds << "\n";
}

int vtkHeightFieldAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkHeightFieldAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector*)
{
  skyline::RequestWhole(in[0]->GetInformationObject(0));
  return 1;
}

skyline::HorizonSettings vtkHeightFieldAlgorithm::Settings(
  const skyline::HorizonInput& surface) const
{
  if (!(this->RefractionCoefficient >= LeastRefraction && this->RefractionCoefficient < 1.0))
  {
    throw std::invalid_argument("the refraction coefficient is " +
      std::to_string(this->RefractionCoefficient) + "; give -100 to below 1, 0.13 in usual air");
  }
  skyline::HorizonSettings settings;
  settings.Method = static_cast<skyline::HorizonMethodKind>(this->Method);
  settings.Shape = static_cast<skyline::Surface>(this->Surface);
  settings.CurvatureDrop = this->Flat ? 0.0 : surface.CurvatureDrop(this->RefractionCoefficient);
  settings.Tolerance = this->Tolerance * skyline::RadiansPerDegree;
  settings.Pyramid = { this->LevelStep, this->LevelOffset, this->LevelDistance, this->LevelSpline };
  return settings;
}

int vtkHeightFieldAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  vtkImageData* input = vtkImageData::GetData(in[0]);
  vtkImageData* output = vtkImageData::GetData(out);
  vtkDataArray* heights = this->GetInputArrayToProcess(0, in);
  const std::string failure = skyline::ReasonOfFailure(input,
    [&]
    {
      skyline::CheckWhole(in[0]->GetInformationObject(0));
      skyline::CheckHeights(input, heights);
      this->Search(input, heights, output);
    });
  if (!failure.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< failure);
    return 0;
  }
  skyline::KeepPiece(out->GetInformationObject(0));
  return 1;
}

void vtkHeightFieldAlgorithm::Search(
  vtkImageData* input, vtkDataArray* heights, vtkImageData* output)
{
  skyline::HorizonInput surface(input, heights);
  const skyline::HorizonSettings settings = this->Settings(surface);
  if (this->Method != PYRAMID)
  {
    this->Pyramids->Clear();
  }
  skyline::HorizonDriver driver(surface, settings, this->Pyramids.get());
  driver.Progress = [this](double part)
  {
    this->UpdateProgress(part);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
    return !this->CheckAbort();
#else
    return this->GetAbortExecute() == 0;
#endif
  };
  output->ShallowCopy(input);
  const bool finished = this->Compute(driver, output);
  for (const skyline::Doubt& doubt : driver.Doubts())
  {
    skyline::Warn(this, doubt);
  }
  this->PrepareSeconds = driver.PrepareSeconds;
  this->SearchSeconds = driver.SearchSeconds;
  this->PyramidBuilds = driver.PyramidBuilds;
  if (!finished)
  {
    output->Initialize();
  }
}
