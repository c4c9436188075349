// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLHeightFieldShadowHeight
 * @brief   how high the shadow of the terrain stands over every post, computed by a graphics processor
 *
 * GPU counterpart of vtkHeightFieldShadowHeight: the same settings and arrays, which differ by the rounding of floats.
 * EXACT and FAST walk every ray by a fragment shader until it has passed the highest post. SWEEP, Lee &
 * Kim's recurrence, is a compute shader (OpenGL 4.3): work groups carry a stretch of a line each through
 * shared memory, 64 lines a run; without compute shaders the host runs it, without an error. Heights
 * are 32-bit floats throughout. The field has to fit in one texture.
 *
 * Where there is no OpenGL context, or it fails, one error says so in one line and the host computes the
 * array. IsOnDevice tells who did.
 */
#ifndef vtkOpenGLHeightFieldShadowHeight_h
#define vtkOpenGLHeightFieldShadowHeight_h

#include "SkylineRenderingModule.h" // For export macro
#include "vtkHeightFieldShadowHeight.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"        // For Device

#include <memory> // For Source

namespace skyline
{
class GpuShadows;
class GpuShadowSource;
} // namespace skyline

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLHeightFieldDevice;

class SKYLINERENDERING_EXPORT vtkOpenGLHeightFieldShadowHeight : public vtkHeightFieldShadowHeight
{
public:
  static vtkOpenGLHeightFieldShadowHeight* New();
  vtkTypeMacro(vtkOpenGLHeightFieldShadowHeight, vtkHeightFieldShadowHeight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Where to compute; default: a device of its own. Several filters may share one.
  void SetDevice(vtkOpenGLHeightFieldDevice* device);
  vtkOpenGLHeightFieldDevice* GetDevice();
  ///@}

  /// Whether the graphics processor made the last result.
  bool IsOnDevice();

  /// The time of the last change of this filter or of its device.
  vtkMTimeType GetMTime() override;

protected:
  vtkOpenGLHeightFieldShadowHeight();
  ~vtkOpenGLHeightFieldShadowHeight() override;

  bool Compute(skyline::HorizonScene& scene, vtkImageData* output) override;

#ifndef __VTK_WRAP__
  std::unique_ptr<skyline::HorizonMethod> MakeMethod(
    skyline::HorizonScene& scene, double slope) override;
#endif

private:
  vtkOpenGLHeightFieldShadowHeight(const vtkOpenGLHeightFieldShadowHeight&) = delete;
  void operator=(const vtkOpenGLHeightFieldShadowHeight&) = delete;

  vtkSmartPointer<vtkOpenGLHeightFieldDevice> Device;
  std::unique_ptr<skyline::GpuShadowSource> Source;
  skyline::GpuShadows* Passes = nullptr; // of the execution
};
VTK_ABI_NAMESPACE_END

#endif
