// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLHeightFieldHorizon
 * @brief   the horizon around each post, computed by a graphics processor
 *
 * GPU counterpart of vtkHeightFieldHorizon with the same array `HorizonElevation`. The values
 * differ by the rounding of floats; Documentation/gpu.md gives the bounds.
 *
 * - EXACT follows each ray to the edge of the data; unlike the host it uses no bounds to stop
 *   early.
 * - FAST computes the exact horizons.
 * - PYRAMID builds its height pyramid on the graphics processor.
 * - SWEEP needs compute shaders (OpenGL 4.3). One invocation follows each line and keeps the convex
 *   hull of the terrain that it has passed in a buffer.
 *
 * Height fields that exceed the texture limit are computed in tiles.
 *
 * If there is no OpenGL context, or if it is lost, the filter reports one error of one line and the
 * host computes the array. For bilinear surfaces, and for SWEEP without compute shaders, the host
 * computes without an error. IsOnDevice returns which of the two computed.
 */
#ifndef vtkOpenGLHeightFieldHorizon_h
#define vtkOpenGLHeightFieldHorizon_h

#include "SkylineRenderingModule.h" // For export macro
#include "vtkHeightFieldHorizon.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <memory> // For Gpu

namespace skyline
{
class GpuFilter;
class GpuShadowPasses;
} // namespace skyline

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLHeightFieldDevice;

class SKYLINERENDERING_EXPORT vtkOpenGLHeightFieldHorizon : public vtkHeightFieldHorizon
{
public:
  static vtkOpenGLHeightFieldHorizon* New();
  vtkTypeMacro(vtkOpenGLHeightFieldHorizon, vtkHeightFieldHorizon);
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
  vtkOpenGLHeightFieldHorizon();
  ~vtkOpenGLHeightFieldHorizon() override;

  bool Store(
    skyline::HorizonDriver& driver, const std::vector<double>& azimuths, float* values) override;

private:
  vtkOpenGLHeightFieldHorizon(const vtkOpenGLHeightFieldHorizon&) = delete;
  void operator=(const vtkOpenGLHeightFieldHorizon&) = delete;

  bool Sweep(skyline::HorizonDriver& driver, const std::vector<double>& azimuths, float* values);

  std::unique_ptr<skyline::GpuFilter> Gpu;
  std::unique_ptr<skyline::GpuShadowPasses> Sweeps;
};
VTK_ABI_NAMESPACE_END

#endif
