// SPDX-License-Identifier: BSD-3-Clause
#include "GpuFilter.h"

#include "Harmonics/SphericalHarmonics.h"
#include "HorizonDriver.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTextureObject.h"

#include <cstddef>
#include <stdexcept>

namespace skyline
{

bool GpuFilter::SetDevice(vtkOpenGLHeightFieldDevice* device)
{
  if (!device || device == this->Device)
  {
    return false;
  }
  this->Harmonics.reset(); // must be destroyed before its device
  this->Device = device;
  return true;
}

bool GpuFilter::Ready()
{
  return this->Device->IsAvailable() && this->Harmonics &&
    this->Generation == this->Device->GetGeneration() && this->Time == this->Device->GetMTime();
}

bool GpuFilter::Attempt(
  vtkObject* filter, HorizonDriver& driver, const std::function<void()>& compute)
{
  this->OnDevice = this->Filled = this->OneTile = false;
  // The graphics processor handles spacings that vary by row. Other distorted maps are left to the
  // host.
  const bool rows = driver.Input().Ground().Uniform() || driver.Input().Ground().ByRows();
  if (!rows || !GpuHarmonics::UnsupportedSetting(driver.UsedSettings()).empty())
  {
    return false;
  }
  if (!this->Ready())
  {
    this->Harmonics.reset();
    // The destructor may have made another context current.
    if (!this->Device->IsAvailable())
    {
      this->ReportFallback(filter, this->Device->GetReason());
      return false;
    }
    this->Harmonics = std::make_unique<GpuHarmonics>(this->Device->Gpu(), this->Device->Limits());
    this->Generation = this->Device->GetGeneration();
    this->Time = this->Device->GetMTime();
  }
  try
  {
    this->Harmonics->Times.Wanted = this->Timed;
    this->OneTile = this->Harmonics->FitsOneTile(driver);
    compute();
    this->OnDevice = true;
    this->LastReason.clear();
    return true;
  }
  catch (const std::runtime_error& error)
  {
    this->Harmonics.reset();
    this->OneTile = this->Filled = false;
    this->ReportFallback(filter, error.what());
    return false;
  }
}

bool GpuFilter::Run(
  vtkObject* filter, HorizonDriver& driver, GpuHarmonics::Task task, bool readBack, bool& finished)
{
  this->Values.clear();
  return this->Attempt(filter, driver,
    [&]()
    {
      if (!readBack && this->OneTile)
      {
        task.Values = nullptr;
      }
      else if (!task.Values)
      {
        const std::ptrdiff_t posts = driver.Input().Posts().Columns * driver.Input().Posts().Rows;
        this->Values.resize(static_cast<std::size_t>(posts * HarmonicCount(task.Bands)));
        task.Values = this->Values.data();
      }
      this->Filled = task.Values != nullptr;
      finished = this->Harmonics->Run(driver, task);
    });
}

bool GpuFilter::Store(vtkObject* filter, HorizonDriver& driver, const std::vector<double>& azimuths,
  float* degrees, bool& finished)
{
  return this->Attempt(
    filter, driver, [&]() { finished = this->Harmonics->Store(driver, azimuths, degrees); });
}

vtkTextureObject* GpuFilter::Image(int index) const
{
  if (!this->OnDevice || !this->OneTile || !this->Harmonics || index < 0 ||
    static_cast<std::size_t>(index) >= this->Harmonics->Images().size())
  {
    return nullptr;
  }
  vtkTextureObject* image = this->Harmonics->Images()[static_cast<std::size_t>(index)];
  return image->GetHandle() != 0 ? image : nullptr;
}

void GpuFilter::RemoveUnread(vtkImageData* output, const char* name) const
{
  if (this->OnDevice && !this->Filled)
  {
    output->GetPointData()->RemoveArray(name);
  }
}

void GpuFilter::ReportFallback(vtkObject* filter, const std::string& reason)
{
  if (reason != this->LastReason)
  {
    vtkErrorWithObjectMacro(
      filter, "the host computes instead of the graphics processor: " << reason);
  }
  this->LastReason = reason;
}

} // namespace skyline
