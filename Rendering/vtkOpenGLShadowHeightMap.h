// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLShadowHeightMap
 * @brief   how high the shadow of the terrain stands over every post, computed by a graphics processor
 *
 * GPU counterpart of vtkShadowHeightMap: the same settings and arrays, which differ by the rounding of floats.
 * EXACT and FAST walk every ray by a fragment shader until it has passed the highest post. SWEEP, Lee &
 * Kim's recurrence, is a compute shader (OpenGL 4.3): work groups carry a stretch of a line each through
 * shared memory, 64 lines a run; without compute shaders the host runs it, without an error. Heights
 * are 32-bit floats throughout. The field has to fit in one texture.
 *
 * Where there is no OpenGL context, or it fails, one error says so in one line and the host computes the
 * array. IsOnDevice tells who did.
 */
#ifndef vtkOpenGLShadowHeightMap_h
#define vtkOpenGLShadowHeightMap_h

#include "SkylineRenderingModule.h" // For export macro
#include "vtkShadowHeightMap.h"
#include "vtkSmartPointer.h" // For Device

#include <memory> // For Source

namespace skyline
{
class GpuShadows;
class GpuShadowSource;
} // namespace skyline
class vtkOpenGLHeightFieldDevice;

class SKYLINERENDERING_EXPORT vtkOpenGLShadowHeightMap : public vtkShadowHeightMap
{
public:
  static vtkOpenGLShadowHeightMap* New();
  vtkTypeMacro(vtkOpenGLShadowHeightMap, vtkShadowHeightMap);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Where to compute; default: a device of its own. Several filters may share one.
  void SetDevice(vtkOpenGLHeightFieldDevice* device);
  vtkOpenGLHeightFieldDevice* GetDevice();
  ///@}

  /// Whether the graphics processor made the last result.
  bool IsOnDevice();

  /// The device too.
  vtkMTimeType GetMTime() override;

protected:
  vtkOpenGLShadowHeightMap();
  ~vtkOpenGLShadowHeightMap() override;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

#ifndef __VTK_WRAP__
  std::unique_ptr<skyline::HorizonMethod> MakeMethod(
    skyline::HorizonDriver& driver, double slope) override;
#endif

private:
  vtkOpenGLShadowHeightMap(const vtkOpenGLShadowHeightMap&) = delete;
  void operator=(const vtkOpenGLShadowHeightMap&) = delete;

  vtkSmartPointer<vtkOpenGLHeightFieldDevice> Device;
  std::unique_ptr<skyline::GpuShadowSource> Source;
  skyline::GpuShadows* Passes = nullptr; // of the execution
};

#endif
