// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLHeightFieldShadowHeight.h"

#include "GpuShadows.h"
#include "HorizonDriver.h"
#include "vtkOpenGLHeightFieldDevice.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkOpenGLHeightFieldShadowHeight);

vtkOpenGLHeightFieldShadowHeight::vtkOpenGLHeightFieldShadowHeight()
  : Device(vtkSmartPointer<vtkOpenGLHeightFieldDevice>::New())
  , Source(std::make_unique<skyline::GpuShadowPasses>())
{
}

vtkOpenGLHeightFieldShadowHeight::~vtkOpenGLHeightFieldShadowHeight()
{
  this->Source.reset(); // must be destroyed before its device
}

void vtkOpenGLHeightFieldShadowHeight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OnDevice: " << this->Source->OnDevice << "\n";
}

void vtkOpenGLHeightFieldShadowHeight::SetDevice(vtkOpenGLHeightFieldDevice* device)
{
  if (device && device != this->Device)
  {
    this->Source = std::make_unique<skyline::GpuShadowPasses>();
    this->Device = device;
    this->Modified();
  }
}

vtkOpenGLHeightFieldDevice* vtkOpenGLHeightFieldShadowHeight::GetDevice()
{
  return this->Device;
}

bool vtkOpenGLHeightFieldShadowHeight::IsOnDevice()
{
  return this->Source->OnDevice;
}

vtkMTimeType vtkOpenGLHeightFieldShadowHeight::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Device->GetMTime());
}

bool vtkOpenGLHeightFieldShadowHeight::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  const bool known = this->Method != PYRAMID && this->Surface == TRIANGLES; // otherwise an error
  this->Passes = known
    ? this->Source->Open(this, this->Device, driver.Input().Field(), this->Method == SWEEP)
    : nullptr;
  const bool finished = this->Superclass::Compute(driver, output);
  this->Passes = nullptr;
  return finished;
}

std::unique_ptr<skyline::HorizonMethod> vtkOpenGLHeightFieldShadowHeight::MakeMethod(
  skyline::HorizonDriver& driver, double slope)
{
  if (!this->Passes)
  {
    return this->Superclass::MakeMethod(driver, slope);
  }
  const skyline::GpuFailure failure = this->Source->Failure(this);
  if (this->Method == SWEEP)
  {
    return std::make_unique<skyline::GpuShadowSweep>(
      *this->Passes, failure, driver.Input().Field(), slope);
  }
  return std::make_unique<skyline::GpuShadowExact>(
    *this->Passes, failure, driver.Input().Field(), slope, driver.UsedSettings().CurvatureDrop);
}
