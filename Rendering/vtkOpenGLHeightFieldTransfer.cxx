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

bool vtkOpenGLHeightFieldTransfer::Compute(skyline::HorizonScene& scene, vtkImageData* output)
{
  const bool finished = this->Superclass::Compute(scene, output);
  this->Gpu->RemoveUnread(output, "TransferSH");
  return finished;
}

bool vtkOpenGLHeightFieldTransfer::Sum(skyline::HorizonScene& scene,
  const std::vector<double>& azimuths, double width, const float* east, const float* north,
  float* values)
{
  bool finished = false;
  return this->Gpu->Run(this, scene, { this->NumberOfBands, &azimuths, width, east, north, values },
           this->ReadBack, finished)
    ? finished
    : this->Superclass::Sum(scene, azimuths, width, east, north, values);
}
