// SPDX-License-Identifier: BSD-3-Clause
// What the filters on the graphics processor have in common: a device, and its passes.
#ifndef skyline_TwinFilter_h
#define skyline_TwinFilter_h

#include "TwinHarmonics.h"

#include "vtkOpenGLHeightFieldDevice.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace skyline
{

class TwinFilter
{
public:
  vtkSmartPointer<vtkOpenGLHeightFieldDevice> Device =
    vtkSmartPointer<vtkOpenGLHeightFieldDevice>::New();
  bool OnDevice = false;     ///< the last result
  bool Filled = false;       ///< and its values were read back
  bool OneTile = false;      ///< and its images are there
  bool Timed = false;        ///< measure
  std::vector<float> Values; ///< of tiles, where the filter has no place for them

  void SetDevice(vtkOpenGLHeightFieldDevice* device);

  /// False if the host has to compute: `reason` says why, once; it is empty where that is no error.
  /// task.Values (null: Values) is filled if readBack, or if one texture does not hold the field.
  bool Run(HorizonScene& scene, TwinHarmonics::Task task, bool readBack, bool& finished,
    std::string& reason);

  /// Likewise: horizons in degrees.
  bool Store(HorizonScene& scene, const std::vector<double>& azimuths, float* degrees,
    bool& finished, std::string& reason);

  vtkTextureObject* Image(int index) const;
  TwinHarmonics* Passes() const { return this->Harmonics.get(); }

  /// Whether the context that made the last images is there, and current.
  bool Ready();

private:
  bool Attempt(HorizonScene& scene, std::string& reason, const std::function<void()>& compute);
  void Tell(const std::string& why, std::string& reason);

  std::unique_ptr<TwinHarmonics> Harmonics;
  int Generation = 0;
  vtkMTimeType Time = 0;
  std::string Told;
};

} // namespace skyline

#endif
