// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLHeightFieldHorizon.h"

#include "HorizonScene.h"
#include "StoreAccumulator.h"
#include "TwinFilter.h"
#include "TwinShadows.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkOpenGLHeightFieldHorizon);

vtkOpenGLHeightFieldHorizon::vtkOpenGLHeightFieldHorizon()
  : Twin(std::make_unique<skyline::TwinFilter>())
  , Sweeps(std::make_unique<skyline::TwinShadowSource>())
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
  const vtkSmartPointer<vtkOpenGLHeightFieldDevice> before = this->Twin->Device;
  if (this->Twin->SetDevice(device))
  {
    this->Sweeps = std::make_unique<skyline::TwinShadowSource>(); // before its device goes
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
  if (this->Method == SWEEP)
  {
    this->Twin->OnDevice = false;
    return this->Sweep(scene, azimuths, values);
  }
  return this->Twin->Store(this, scene, azimuths, values, finished)
    ? finished
    : this->Superclass::Store(scene, azimuths, values);
}

bool vtkOpenGLHeightFieldHorizon::Sweep(
  skyline::HorizonScene& scene, const std::vector<double>& azimuths, float* values)
{
  skyline::TwinShadows* passes =
    this->Sweeps->Open(this, this->Twin->Device, scene.PreparedField(), true);
  if (!passes)
  {
    return this->Superclass::Store(scene, azimuths, values);
  }
  skyline::TwinHorizonSweep method(
    *passes, this->Sweeps->Failure(this), scene.PreparedField(), scene.UsedSettings());
  skyline::StoreAccumulator store(
    scene.Posts().Columns, values, static_cast<std::ptrdiff_t>(azimuths.size()));
  scene.DoubtOneMetric("the sweep", scene.CentreMetric());
  const bool finished = scene.Run(method, azimuths, 0.0, store, skyline::AzimuthAxes::Image);
  this->Twin->OnDevice = this->Sweeps->OnDevice;
  return finished;
}
