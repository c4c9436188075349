// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLHeightFieldVisibility.h"

#include "GpuFilter.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkOpenGLHeightFieldVisibility);

vtkOpenGLHeightFieldVisibility::vtkOpenGLHeightFieldVisibility()
  : Gpu(std::make_unique<skyline::GpuFilter>())
{
}

vtkOpenGLHeightFieldVisibility::~vtkOpenGLHeightFieldVisibility() = default;

void vtkOpenGLHeightFieldVisibility::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReadBack: " << this->ReadBack << "\n"
     << indent << "OnDevice: " << this->Gpu->OnDevice << "\n";
}

void vtkOpenGLHeightFieldVisibility::SetDevice(vtkOpenGLHeightFieldDevice* device)
{
  if (this->Gpu->SetDevice(device))
  {
    this->Modified();
  }
}

vtkOpenGLHeightFieldDevice* vtkOpenGLHeightFieldVisibility::GetDevice()
{
  return this->Gpu->Device;
}

bool vtkOpenGLHeightFieldVisibility::IsOnDevice()
{
  return this->Gpu->OnDevice;
}

vtkTextureObject* vtkOpenGLHeightFieldVisibility::GetTexture(int index)
{
  return this->Gpu->Image(index);
}

vtkMTimeType vtkOpenGLHeightFieldVisibility::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Gpu->Device->GetMTime());
}

bool vtkOpenGLHeightFieldVisibility::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  const bool finished = this->Superclass::Compute(driver, output);
  this->Gpu->RemoveUnread(output, "VisibilitySH");
  return finished;
}

bool vtkOpenGLHeightFieldVisibility::Sum(skyline::HorizonDriver& driver,
  const std::vector<double>& azimuths, double width, const float* east, const float* north,
  float* values)
{
  bool finished = false;
  return this->Gpu->Run(this, driver,
           { this->NumberOfBands, &azimuths, width, east, north, values }, this->ReadBack, finished)
    ? finished
    : this->Superclass::Sum(driver, azimuths, width, east, north, values);
}
