// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLHeightFieldIrradiance.h"

#include "Azimuths.h"
#include "GpuFilter.h"
#include "HarmonicLight.h"
#include "HorizonDriver.h"
#include "Shared/Constants.h"
#include "vtkSkylineLampLight.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkTextureObject.h"

#include <algorithm>

vtkStandardNewMacro(vtkOpenGLHeightFieldIrradiance);

struct vtkOpenGLHeightFieldIrradiance::Internals
{
  skyline::GpuFilter Gpu;
  std::vector<double> Key; // identifies the transfer that is held
  skyline::GpuTexture Lit;
};

vtkOpenGLHeightFieldIrradiance::vtkOpenGLHeightFieldIrradiance()
  : Internal(std::make_unique<Internals>())
{
  this->LightMethod = HARMONICS;
}

vtkOpenGLHeightFieldIrradiance::~vtkOpenGLHeightFieldIrradiance() = default;

void vtkOpenGLHeightFieldIrradiance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReadBack: " << this->ReadBack << "\n"
     << indent << "MeasurePasses: " << this->MeasurePasses << "\n"
     << indent << "OnDevice: " << this->Internal->Gpu.OnDevice << "\n";
}

void vtkOpenGLHeightFieldIrradiance::SetDevice(vtkOpenGLHeightFieldDevice* device)
{
  if (device && device != this->Internal->Gpu.Device)
  {
    this->Internal->Lit = nullptr; // must be released before its device
    this->Internal->Key.clear();
    this->Internal->Gpu.SetDevice(device);
    this->Modified();
  }
}

vtkOpenGLHeightFieldDevice* vtkOpenGLHeightFieldIrradiance::GetDevice()
{
  return this->Internal->Gpu.Device;
}

bool vtkOpenGLHeightFieldIrradiance::IsOnDevice()
{
  return this->Internal->Gpu.OnDevice;
}

vtkTextureObject* vtkOpenGLHeightFieldIrradiance::GetTexture()
{
  const skyline::GpuTexture& lit = this->Internal->Lit;
  return lit && lit->GetHandle() != 0 ? lit.GetPointer() : nullptr;
}

void vtkOpenGLHeightFieldIrradiance::GetPassSeconds(double seconds[5])
{
  std::fill_n(seconds, 5, 0.0);
  if (const skyline::GpuHarmonics* passes = this->Internal->Gpu.Passes())
  {
    const skyline::GpuTimes& times = passes->Times;
    seconds[0] = times.Load;
    seconds[1] = times.Horizons;
    seconds[2] = times.Wedges;
    seconds[3] = times.Light;
    seconds[4] = times.Read;
  }
}

vtkMTimeType vtkOpenGLHeightFieldIrradiance::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Internal->Gpu.Device->GetMTime());
}

bool vtkOpenGLHeightFieldIrradiance::HasLamps()
{
  for (int i = 0; i < this->GetNumberOfLights(); ++i)
  {
    auto* lamp = vtkSkylineLampLight::SafeDownCast(this->GetLight(i));
    if (lamp && lamp->GetSwitch())
    {
      return true;
    }
  }
  return false;
}

bool vtkOpenGLHeightFieldIrradiance::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  this->Internal->Gpu.OnDevice = false;
  this->Internal->Lit = nullptr;
  const bool finished = this->Superclass::Compute(driver, output);
  if (finished && this->Internal->Lit && !this->ReadBack && !this->HasLamps())
  {
    output->GetPointData()->RemoveArray("Irradiance");
  }
  return finished;
}

bool vtkOpenGLHeightFieldIrradiance::LightByHarmonics(skyline::HorizonDriver& driver,
  const skyline::HarmonicLight& light, const std::vector<double>& key,
  const skyline::LitPosts& posts)
{
  using namespace skyline;
  GpuFilter& gpu = this->Internal->Gpu;
  const Grid& grid = driver.Input().Posts();
  const auto count = static_cast<std::size_t>(grid.Columns * grid.Rows);
  gpu.Timed = this->MeasurePasses;
  if (GpuHarmonics* passes = gpu.Passes())
  {
    passes->Times = GpuTimes();
    passes->Times.Wanted = this->MeasurePasses;
  }
  if (!gpu.Ready() || key != this->Internal->Key)
  {
    this->Internal->Key.clear();
    const std::vector<float> level(this->Horizontal ? count : 0, 0.0f);
    const std::vector<double> azimuths = EvenAzimuths(this->NumberOfAzimuths);
    GpuHarmonics::Task task;
    task.Bands = this->HarmonicBands;
    task.Azimuths = &azimuths;
    task.Width = 2.0 * Pi / this->NumberOfAzimuths;
    task.East = this->Horizontal ? level.data() : posts.East;
    task.North = this->Horizontal ? level.data() : posts.North;
    bool finished = false;
    if (!gpu.Run(this, driver, task, false, finished))
    {
      return this->Superclass::LightByHarmonics(driver, light, key, posts);
    }
    ++this->EnvironmentPasses;
    this->SearchedAzimuths += this->NumberOfAzimuths;
    if (!finished)
    {
      return false;
    }
    this->Internal->Key = key;
  }
  gpu.OnDevice = true;
  if (!gpu.OneTile)
  {
    light.Light(gpu.Values.data(), 0, static_cast<vtkIdType>(count), posts.Irradiance);
    return true;
  }
  this->Internal->Lit = gpu.Passes()->Light(light.GetCoefficients());
  if (this->ReadBack || this->HasLamps())
  {
    std::vector<float> texels(4 * count);
    gpu.Passes()->ReadImage(this->Internal->Lit, texels.data());
    for (std::size_t post = 0; post < count; ++post)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        posts.Irradiance[3 * post + c] += texels[4 * post + c];
      }
    }
  }
  return true;
}
