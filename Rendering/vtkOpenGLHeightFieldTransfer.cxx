// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLHeightFieldTransfer.h"

#include "HorizonScene.h"
#include "TwinFilter.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>

vtkStandardNewMacro(vtkOpenGLHeightFieldTransfer);

vtkOpenGLHeightFieldTransfer::vtkOpenGLHeightFieldTransfer()
  : Twin(std::make_unique<skyline::TwinFilter>())
{
}

vtkOpenGLHeightFieldTransfer::~vtkOpenGLHeightFieldTransfer() = default;

void vtkOpenGLHeightFieldTransfer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReadBack: " << this->ReadBack << "\n"
     << indent << "OnDevice: " << this->Twin->OnDevice << "\n";
}

void vtkOpenGLHeightFieldTransfer::SetDevice(vtkOpenGLHeightFieldDevice* device)
{
  if (device && device != this->Twin->Device)
  {
    this->Twin->SetDevice(device);
    this->Modified();
  }
}

vtkOpenGLHeightFieldDevice* vtkOpenGLHeightFieldTransfer::GetDevice()
{
  return this->Twin->Device;
}

bool vtkOpenGLHeightFieldTransfer::IsOnDevice()
{
  return this->Twin->OnDevice;
}

vtkTextureObject* vtkOpenGLHeightFieldTransfer::GetTexture(int index)
{
  return this->Twin->Image(index);
}

vtkMTimeType vtkOpenGLHeightFieldTransfer::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Twin->Device->GetMTime());
}

bool vtkOpenGLHeightFieldTransfer::Compute(skyline::HorizonScene& scene, vtkImageData* output)
{
  const bool finished = this->Superclass::Compute(scene, output);
  if (finished && this->Twin->OnDevice && !this->Twin->Filled)
  {
    output->GetPointData()->RemoveArray("TransferSH");
  }
  return finished;
}

bool vtkOpenGLHeightFieldTransfer::Sum(skyline::HorizonScene& scene,
  const std::vector<double>& azimuths, double width, const float* east, const float* north,
  float* values)
{
  skyline::TwinHarmonics::Task task;
  task.Bands = this->NumberOfBands;
  task.Azimuths = &azimuths;
  task.Width = width;
  task.East = east;
  task.North = north;
  task.Values = values;
  std::string reason;
  bool finished = false;
  if (this->Twin->Run(scene, task, this->ReadBack, finished, reason))
  {
    return finished;
  }
  if (!reason.empty())
  {
    vtkErrorMacro("the host computes in place of the graphics processor: " << reason);
  }
  return this->Superclass::Sum(scene, azimuths, width, east, north, values);
}
