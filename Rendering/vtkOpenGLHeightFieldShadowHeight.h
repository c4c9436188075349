// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLHeightFieldShadowHeight
 * @brief   the height of the terrain's shadow over each post, computed by a graphics processor
 *
 * GPU counterpart of vtkHeightFieldShadowHeight with the same settings and arrays. The values
 * differ by the rounding of floats; all heights are 32-bit floats. The height field must fit into
 * one texture.
 *
 * - EXACT and FAST follow each ray, in a fragment shader, until the ray is above the highest post.
 * - SWEEP, the recurrence of Lee & Kim, needs compute shaders (OpenGL 4.3). Each work group
 *   processes a section of a line in shared memory, 64 lines per run. Without compute shaders the
 *   host computes, without an error.
 *
 * If there is no OpenGL context, or if a pass fails, the filter reports one error of one line and
 * the host computes the array. IsOnDevice returns which of the two computed.
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
class GpuShadowPasses;
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
  /// The device on which to compute. Default: a device of this filter alone. Several filters can
  /// share a device.
  void SetDevice(vtkOpenGLHeightFieldDevice* device);
  vtkOpenGLHeightFieldDevice* GetDevice();
  ///@}

  /// Returns whether the graphics processor computed the last result.
  bool IsOnDevice();

  /// The modified time, including that of the device.
  vtkMTimeType GetMTime() override;

protected:
  vtkOpenGLHeightFieldShadowHeight();
  ~vtkOpenGLHeightFieldShadowHeight() override;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

#ifndef __VTK_WRAP__
  std::unique_ptr<skyline::HorizonMethod> MakeMethod(
    skyline::HorizonDriver& driver, double slope) override;
#endif

private:
  vtkOpenGLHeightFieldShadowHeight(const vtkOpenGLHeightFieldShadowHeight&) = delete;
  void operator=(const vtkOpenGLHeightFieldShadowHeight&) = delete;

  vtkSmartPointer<vtkOpenGLHeightFieldDevice> Device;
  std::unique_ptr<skyline::GpuShadowPasses> Source;
  skyline::GpuShadows* Passes = nullptr; // during the execution
};
VTK_ABI_NAMESPACE_END

#endif
