// SPDX-License-Identifier: BSD-3-Clause
// Timing filters, on the host or on the graphics processor.
#ifndef skyline_DeviceRun_h
#define skyline_DeviceRun_h

#include "Result.h"
#include "Stage.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkImageData;
class vtkOpenGLHeightFieldDevice;
VTK_ABI_NAMESPACE_END

namespace skyline
{
namespace benchmark
{

/// Updates a filter again and again, each time as if the heights had changed; nanoseconds are for
/// one of `count` parts. One thread, unless `threads` says otherwise. std::runtime_error if it fails.
Result TimeUpdates(
  vtkAlgorithm* filter, vtkImageData* heights, const Effort& effort, double count, int threads = 1);

/// std::runtime_error with a one-line reason where there is no OpenGL context.
void RequireDevice(vtkOpenGLHeightFieldDevice* device);

/// std::runtime_error if the host had to compute.
void CheckOnDevice(bool onDevice);

/// Forgets the time of the host's processor, which only waits.
void KeepWallOnly(Result& result);

} // namespace benchmark
} // namespace skyline

#endif
