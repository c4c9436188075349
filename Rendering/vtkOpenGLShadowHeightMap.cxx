// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLShadowHeightMap.h"

#include "GpuShadows.h"
#include "HorizonScene.h"
#include "vtkOpenGLHeightFieldDevice.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkOpenGLShadowHeightMap);

vtkOpenGLShadowHeightMap::vtkOpenGLShadowHeightMap()
  : Device(vtkSmartPointer<vtkOpenGLHeightFieldDevice>::New())
  , Source(std::make_unique<skyline::GpuShadowSource>())
{
}

vtkOpenGLShadowHeightMap::~vtkOpenGLShadowHeightMap()
{
  this->Source.reset(); // must be destroyed before its device
}

void vtkOpenGLShadowHeightMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OnDevice: " << this->Source->OnDevice << "\n";
}

void vtkOpenGLShadowHeightMap::SetDevice(vtkOpenGLHeightFieldDevice* device)
{
  if (device && device != this->Device)
  {
    this->Source = std::make_unique<skyline::GpuShadowSource>();
    this->Device = device;
    this->Modified();
  }
}

vtkOpenGLHeightFieldDevice* vtkOpenGLShadowHeightMap::GetDevice()
{
  return this->Device;
}

bool vtkOpenGLShadowHeightMap::IsOnDevice()
{
  return this->Source->OnDevice;
}

vtkMTimeType vtkOpenGLShadowHeightMap::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Device->GetMTime());
}

bool vtkOpenGLShadowHeightMap::Compute(skyline::HorizonScene& scene, vtkImageData* output)
{
  const bool known = this->Method != PYRAMID && this->Surface == TRIANGLES; // otherwise an error
  this->Passes = known
    ? this->Source->Open(this, this->Device, scene.PreparedField(), this->Method == SWEEP)
    : nullptr;
  const bool finished = this->Superclass::Compute(scene, output);
  this->Passes = nullptr;
  return finished;
}

std::unique_ptr<skyline::HorizonMethod> vtkOpenGLShadowHeightMap::MakeMethod(
  skyline::HorizonScene& scene, double slope)
{
  if (!this->Passes)
  {
    return this->Superclass::MakeMethod(scene, slope);
  }
  const skyline::GpuFailure failure = this->Source->Failure(this);
  if (this->Method == SWEEP)
  {
    return std::make_unique<skyline::GpuShadowSweep>(
      *this->Passes, failure, scene.PreparedField(), slope);
  }
  return std::make_unique<skyline::GpuShadowExact>(
    *this->Passes, failure, scene.PreparedField(), slope, scene.UsedSettings().Sink);
}
