// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLHeightFieldHorizon.h"

#include "GpuFilter.h"
#include "GpuShadows.h"
#include "Horizon/StoreAccumulator.h"
#include "HorizonDriver.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkOpenGLHeightFieldHorizon);

vtkOpenGLHeightFieldHorizon::vtkOpenGLHeightFieldHorizon()
  : Gpu(std::make_unique<skyline::GpuFilter>())
  , Sweeps(std::make_unique<skyline::GpuShadowPasses>())
{
}

vtkOpenGLHeightFieldHorizon::~vtkOpenGLHeightFieldHorizon() = default;

void vtkOpenGLHeightFieldHorizon::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OnDevice: " << this->Gpu->OnDevice << "\n";
}

void vtkOpenGLHeightFieldHorizon::SetDevice(vtkOpenGLHeightFieldDevice* device)
{
  const vtkSmartPointer<vtkOpenGLHeightFieldDevice> before = this->Gpu->Device;
  if (this->Gpu->SetDevice(device))
  {
    // Destroys the old passes before their device is released.
    this->Sweeps = std::make_unique<skyline::GpuShadowPasses>();
    this->Modified();
  }
}

vtkOpenGLHeightFieldDevice* vtkOpenGLHeightFieldHorizon::GetDevice()
{
  return this->Gpu->Device;
}

bool vtkOpenGLHeightFieldHorizon::IsOnDevice()
{
  return this->Gpu->OnDevice;
}

vtkMTimeType vtkOpenGLHeightFieldHorizon::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Gpu->Device->GetMTime());
}

bool vtkOpenGLHeightFieldHorizon::Store(
  skyline::HorizonDriver& driver, const std::vector<double>& azimuths, float* values)
{
  bool finished = false;
  if (this->Method == SWEEP)
  {
    this->Gpu->OnDevice = false;
    return this->Sweep(driver, azimuths, values);
  }
  return this->Gpu->Store(this, driver, azimuths, values, finished)
    ? finished
    : this->Superclass::Store(driver, azimuths, values);
}

bool vtkOpenGLHeightFieldHorizon::Sweep(
  skyline::HorizonDriver& driver, const std::vector<double>& azimuths, float* values)
{
  skyline::GpuShadows* passes =
    this->Sweeps->Open(this, this->Gpu->Device, driver.Input().Field(), true);
  if (!passes)
  {
    return this->Superclass::Store(driver, azimuths, values);
  }
  skyline::GpuHorizonSweep method(
    *passes, this->Sweeps->Failure(this), driver.Input().Field(), driver.UsedSettings());
  skyline::StoreAccumulator store(
    driver.Input().Posts().Columns, values, static_cast<std::ptrdiff_t>(azimuths.size()));
  driver.DoubtOneMetric("the sweep", driver.Input().CentreMetric());
  const bool finished = driver.Run(method, azimuths, 0.0, store, skyline::AzimuthAxes::Image);
  this->Gpu->OnDevice = this->Sweeps->OnDevice;
  return finished;
}
