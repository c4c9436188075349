// SPDX-License-Identifier: BSD-3-Clause
// Measures the run time of filters, on the host or on the graphics processor.
#ifndef skyline_DeviceRun_h
#define skyline_DeviceRun_h

#include "ReferenceScene.h"
#include "Result.h"

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

/// Updates a filter repeatedly, each time after a change of the heights. The nanoseconds are for
/// one of `count` parts. Runs on one thread unless `threads` says otherwise. Throws
/// std::runtime_error if the filter fails.
Result TimeUpdates(
  vtkAlgorithm* filter, vtkImageData* heights, const Effort& effort, double count, int threads = 1);

/// Throws std::runtime_error with a one-line reason if there is no OpenGL context.
void RequireDevice(vtkOpenGLHeightFieldDevice* device);

/// Throws std::runtime_error if the host computed the result.
void CheckOnDevice(bool onDevice);

/// Deletes the CPU times, in which the host only waits for the graphics processor.
void KeepWallOnly(Result& result);

} // namespace benchmark
} // namespace skyline

#endif
