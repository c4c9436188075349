// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLHeightFieldTransfer.h"

#include "GpuFilter.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkOpenGLHeightFieldTransfer);

vtkOpenGLHeightFieldTransfer::vtkOpenGLHeightFieldTransfer()
  : Gpu(std::make_unique<skyline::GpuFilter>())
{
}

vtkOpenGLHeightFieldTransfer::~vtkOpenGLHeightFieldTransfer() = default;

void vtkOpenGLHeightFieldTransfer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReadBack: " << this->ReadBack << "\n"
     << indent << "OnDevice: " << this->Gpu->OnDevice << "\n";
}

void vtkOpenGLHeightFieldTransfer::SetDevice(vtkOpenGLHeightFieldDevice* device)
{
  if (this->Gpu->SetDevice(device))
  {
    this->Modified();
  }
}

vtkOpenGLHeightFieldDevice* vtkOpenGLHeightFieldTransfer::GetDevice()
{
  return this->Gpu->Device;
}

bool vtkOpenGLHeightFieldTransfer::IsOnDevice()
{
  return this->Gpu->OnDevice;
}

vtkTextureObject* vtkOpenGLHeightFieldTransfer::GetTexture(int index)
{
  return this->Gpu->Image(index);
}

vtkMTimeType vtkOpenGLHeightFieldTransfer::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Gpu->Device->GetMTime());
}

bool vtkOpenGLHeightFieldTransfer::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  const bool finished = this->Superclass::Compute(driver, output);
  this->Gpu->RemoveUnread(output, "TransferSH");
  return finished;
}

bool vtkOpenGLHeightFieldTransfer::Sum(skyline::HorizonDriver& driver,
  const std::vector<double>& azimuths, double width, const float* east, const float* north,
  float* values)
{
  bool finished = false;
  return this->Gpu->Run(this, driver,
           { this->NumberOfBands, &azimuths, width, east, north, values }, this->ReadBack, finished)
    ? finished
    : this->Superclass::Sum(driver, azimuths, width, east, north, values);
}
