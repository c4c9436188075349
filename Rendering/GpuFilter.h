// SPDX-License-Identifier: BSD-3-Clause
// What the filters on the graphics processor have in common: a device, and its passes.
#ifndef skyline_GpuFilter_h
#define skyline_GpuFilter_h

#include "GpuHarmonics.h"

#include "vtkOpenGLHeightFieldDevice.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkImageData;

namespace skyline
{

class GpuFilter
{
public:
  vtkSmartPointer<vtkOpenGLHeightFieldDevice> Device =
    vtkSmartPointer<vtkOpenGLHeightFieldDevice>::New();
  bool OnDevice = false;     ///< the last result
  bool Filled = false;       ///< and its values were read back
  bool OneTile = false;      ///< and its images are there
  bool Timed = false;        ///< measure
  std::vector<float> Values; ///< of tiles, where the filter has no place for them

  /// Whether it is another one.
  bool SetDevice(vtkOpenGLHeightFieldDevice* device);

  /// False if the host has to compute; where that is an error, the filter reports it, once.
  /// task.Values (null: Values) is filled if readBack, or if one texture does not hold the field.
  bool Run(vtkObject* filter, HorizonDriver& driver, GpuHarmonics::Task task, bool readBack,
    bool& finished);

  /// Likewise: horizons in degrees.
  bool Store(vtkObject* filter, HorizonDriver& driver, const std::vector<double>& azimuths,
    float* degrees, bool& finished);

  /// Takes an array off an output if nobody read its values back.
  void RemoveUnread(vtkImageData* output, const char* name) const;

  vtkTextureObject* Image(int index) const;
  GpuHarmonics* Passes() const { return this->Harmonics.get(); }

  /// Whether the context that made the last images is there, and current.
  bool Ready();

private:
  bool Attempt(vtkObject* filter, HorizonDriver& driver, const std::function<void()>& compute);
  void Tell(vtkObject* filter, const std::string& reason);

  std::unique_ptr<GpuHarmonics> Harmonics;
  int Generation = 0;
  vtkMTimeType Time = 0;
  std::string Told;
};

} // namespace skyline

#endif
