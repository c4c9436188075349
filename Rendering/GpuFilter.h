// SPDX-License-Identifier: BSD-3-Clause
// What all filters on the graphics processor share: a device and the passes that run on it.
#ifndef skyline_GpuFilter_h
#define skyline_GpuFilter_h

#include "GpuHarmonics.h"

#include "vtkOpenGLHeightFieldDevice.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

class GpuFilter
{
public:
  vtkSmartPointer<vtkOpenGLHeightFieldDevice> Device =
    vtkSmartPointer<vtkOpenGLHeightFieldDevice>::New();
  bool OnDevice = false;     ///< whether the device computed the last result
  bool Filled = false;       ///< and whether its values were read back
  bool OneTile = false;      ///< and whether its images are available
  bool Timed = false;        ///< whether to measure the times of the passes
  std::vector<float> Values; ///< the values of a tiled run, if the filter has no array for them

  /// Returns whether the device changed.
  bool SetDevice(vtkOpenGLHeightFieldDevice* device);

  /// Computes harmonics. Returns false if the host has to compute; if the cause is an error, the
  /// filter reports it once.
  /// task.Values (or Values if it is null) is filled if readBack is true or if the field does not
  /// fit into one texture.
  bool Run(vtkObject* filter, HorizonDriver& driver, GpuHarmonics::Task task, bool readBack,
    bool& finished);

  /// The same for horizons, in degrees.
  bool Store(vtkObject* filter, HorizonDriver& driver, const std::vector<double>& azimuths,
    float* degrees, bool& finished);

  /// Removes an array from the output if its values were not read back.
  void RemoveUnread(vtkImageData* output, const char* name) const;

  vtkTextureObject* Image(int index) const;
  GpuHarmonics* Passes() const { return this->Harmonics.get(); }

  /// Whether the context that made the last images still exists and is current.
  bool Ready();

private:
  bool Attempt(vtkObject* filter, HorizonDriver& driver, const std::function<void()>& compute);
  void ReportFallback(vtkObject* filter, const std::string& reason);

  std::unique_ptr<GpuHarmonics> Harmonics;
  int Generation = 0;
  vtkMTimeType Time = 0;
  std::string LastReason;
};

} // namespace skyline

#endif
