// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLHeightFieldHorizon.h"

#include "TwinFilter.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkOpenGLHeightFieldHorizon);

vtkOpenGLHeightFieldHorizon::vtkOpenGLHeightFieldHorizon()
  : Twin(std::make_unique<skyline::TwinFilter>())
{
}

vtkOpenGLHeightFieldHorizon::~vtkOpenGLHeightFieldHorizon() = default;

void vtkOpenGLHeightFieldHorizon::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OnDevice: " << this->Twin->OnDevice << "\n";
}

void vtkOpenGLHeightFieldHorizon::SetDevice(vtkOpenGLHeightFieldDevice* device)
{
  if (this->Twin->SetDevice(device))
  {
    this->Modified();
  }
}

vtkOpenGLHeightFieldDevice* vtkOpenGLHeightFieldHorizon::GetDevice()
{
  return this->Twin->Device;
}

bool vtkOpenGLHeightFieldHorizon::IsOnDevice()
{
  return this->Twin->OnDevice;
}

vtkMTimeType vtkOpenGLHeightFieldHorizon::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Twin->Device->GetMTime());
}

bool vtkOpenGLHeightFieldHorizon::Store(
  skyline::HorizonScene& scene, const std::vector<double>& azimuths, float* values)
{
  bool finished = false;
  return this->Twin->Store(this, scene, azimuths, values, finished)
    ? finished
    : this->Superclass::Store(scene, azimuths, values);
}
