// SPDX-License-Identifier: BSD-3-Clause
#include "DeviceRun.h"

#include "Data/ErrorReason.h"
#include "SceneImage.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLHeightFieldDevice.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <stdexcept>
#include <string>

namespace skyline
{
namespace benchmark
{

namespace
{

void KeepReason(vtkObject*, unsigned long, void* reason, void* message)
{
  auto& text = *static_cast<std::string*>(reason);
  text = text.empty() ? static_cast<const char*>(message) : text;
}

} // namespace

Result TimeUpdates(
  vtkAlgorithm* filter, vtkImageData* heights, const Effort& effort, double count, int threads)
{
  std::string reason;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetCallback(KeepReason);
  keep->SetClientData(&reason);
  filter->AddObserver(vtkCommand::ErrorEvent, keep);
  if (threads == 1)
  {
    vtkSMPTools::SetBackend("Sequential");
  }
  else
  {
    vtkSMPTools::SetBackend("STDThread");
    vtkSMPTools::Initialize(threads);
  }
  const PeakMemory memory;
  RepeatTimer timer;
  while (timer.Next(effort.Repeats, effort.Seconds))
  {
    Touch(heights);
    timer.Search([&] { filter->Update(); });
    if (!reason.empty())
    {
      throw std::runtime_error(ErrorReason(reason));
    }
  }
  Result result;
  result.FloatsPerPost = memory.FloatsPerPost(static_cast<double>(heights->GetNumberOfPoints()));
  timer.Report(result, count);
  result.PrepareNs = result.SearchNs = NotMeasured;
  result.Threads = threads;
  if (threads != 1) // the clock measures the calling thread only
  {
    result.TotalNs = result.TotalMedianNs = result.ColdNs = NotMeasured;
  }
  result.Ran = true;
  return result;
}

void RequireDevice(vtkOpenGLHeightFieldDevice* device)
{
  if (!device->IsAvailable())
  {
    throw std::runtime_error("no OpenGL context: " + device->GetReason());
  }
}

void CheckOnDevice(bool onDevice)
{
  if (!onDevice)
  {
    throw std::runtime_error("the graphics processor could not compute it, and the host did");
  }
}

void KeepWallOnly(Result& result)
{
  result.TotalNs = result.TotalMedianNs = result.ColdNs = result.FloatsPerPost = NotMeasured;
  result.Threads = NotMeasured;
}

} // namespace benchmark
} // namespace skyline
