// SPDX-License-Identifier: BSD-3-Clause
#include "TwinFilter.h"

#include "HorizonScene.h"
#include "SphericalHarmonics.h"

#include "vtkTextureObject.h"

#include <cstddef>
#include <stdexcept>

namespace skyline
{

void TwinFilter::SetDevice(vtkOpenGLHeightFieldDevice* device)
{
  this->Harmonics.reset(); // before its device goes
  this->Device = device;
}

bool TwinFilter::Ready()
{
  return this->Device->IsAvailable() && this->Harmonics &&
    this->Generation == this->Device->GetGeneration() && this->Time == this->Device->GetMTime();
}

bool TwinFilter::Attempt(
  HorizonScene& scene, std::string& reason, const std::function<void()>& compute)
{
  this->OnDevice = this->Filled = this->OneTile = false;
  if (!TwinHarmonics::Unknown(scene.UsedSettings()).empty())
  {
    return false;
  }
  if (!this->Ready())
  {
    this->Harmonics.reset();
    // What goes with them may have made another context current.
    if (!this->Device->IsAvailable())
    {
      this->Tell(this->Device->GetReason(), reason);
      return false;
    }
    this->Harmonics = std::make_unique<TwinHarmonics>(this->Device->Twin(), this->Device->Limits());
    this->Generation = this->Device->GetGeneration();
    this->Time = this->Device->GetMTime();
  }
  try
  {
    this->Harmonics->Times.Wanted = this->Timed;
    this->OneTile = this->Harmonics->FitsOneTile(scene);
    compute();
    this->OnDevice = true;
    this->Told.clear();
    return true;
  }
  catch (const std::runtime_error& error)
  {
    this->Harmonics.reset();
    this->OneTile = this->Filled = false;
    this->Tell(error.what(), reason);
    return false;
  }
}

bool TwinFilter::Run(
  HorizonScene& scene, TwinHarmonics::Task task, bool readBack, bool& finished, std::string& reason)
{
  this->Values.clear();
  return this->Attempt(scene, reason,
    [&]()
    {
      if (!readBack && this->OneTile)
      {
        task.Values = nullptr;
      }
      else if (!task.Values)
      {
        const std::ptrdiff_t posts = scene.Posts().Columns * scene.Posts().Rows;
        this->Values.resize(static_cast<std::size_t>(posts * HarmonicCount(task.Bands)));
        task.Values = this->Values.data();
      }
      this->Filled = task.Values != nullptr;
      finished = this->Harmonics->Run(scene, task);
    });
}

bool TwinFilter::Store(HorizonScene& scene, const std::vector<double>& azimuths, float* degrees,
  bool& finished, std::string& reason)
{
  return this->Attempt(
    scene, reason, [&]() { finished = this->Harmonics->Store(scene, azimuths, degrees); });
}

vtkTextureObject* TwinFilter::Image(int index) const
{
  if (!this->OnDevice || !this->OneTile || !this->Harmonics || index < 0 ||
    static_cast<std::size_t>(index) >= this->Harmonics->Images().size())
  {
    return nullptr;
  }
  vtkTextureObject* image = this->Harmonics->Images()[static_cast<std::size_t>(index)];
  return image->GetHandle() != 0 ? image : nullptr;
}

void TwinFilter::Tell(const std::string& why, std::string& reason)
{
  reason = why == this->Told ? "" : why;
  this->Told = why;
}

} // namespace skyline
