// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLHeightFieldHorizon.h"

#include "HorizonScene.h"
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
  if (device && device != this->Twin->Device)
  {
    this->Twin->SetDevice(device);
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
  std::string reason;
  bool finished = false;
  if (this->Twin->Store(scene, azimuths, values, finished, reason))
  {
    return finished;
  }
  if (!reason.empty())
  {
    vtkErrorMacro("the host computes in place of the graphics processor: " << reason);
  }
  return this->Superclass::Store(scene, azimuths, values);
}
