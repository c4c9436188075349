// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLHeightFieldHorizon
 * @brief   the horizon all around every post, computed by a graphics processor
 *
 * GPU counterpart of vtkHeightFieldHorizon: the same array `HorizonElevation`, which differs by the rounding of
 * floats (Documentation/gpu.md has the bounds). EXACT walks every ray to the edge of the data, without
 * the host's bounds; FAST takes the exact horizons, PYRAMID its own. Height fields above OpenGL's
 * texture limit go tile by tile.
 *
 * Where there is no OpenGL context, or it is lost, one error says so in one line and the host computes
 * the array. SWEEP needs compute shaders (OpenGL 4.3): one invocation marches along each line, the hull of
 * what it has passed in a buffer; without them, and for bilinear surfaces, the host computes anyway, without
 * an error. IsOnDevice tells who did.
 */
#ifndef vtkOpenGLHeightFieldHorizon_h
#define vtkOpenGLHeightFieldHorizon_h

#include "SkylineRenderingModule.h" // For export macro
#include "vtkHeightFieldHorizon.h"

#include <memory> // For Gpu

namespace skyline
{
class GpuFilter;
class GpuShadowSource;
} // namespace skyline
class vtkOpenGLHeightFieldDevice;

class SKYLINERENDERING_EXPORT vtkOpenGLHeightFieldHorizon : public vtkHeightFieldHorizon
{
public:
  static vtkOpenGLHeightFieldHorizon* New();
  vtkTypeMacro(vtkOpenGLHeightFieldHorizon, vtkHeightFieldHorizon);
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
  vtkOpenGLHeightFieldHorizon();
  ~vtkOpenGLHeightFieldHorizon() override;

  bool Store(
    skyline::HorizonDriver& driver, const std::vector<double>& azimuths, float* values) override;

private:
  vtkOpenGLHeightFieldHorizon(const vtkOpenGLHeightFieldHorizon&) = delete;
  void operator=(const vtkOpenGLHeightFieldHorizon&) = delete;

  bool Sweep(skyline::HorizonDriver& driver, const std::vector<double>& azimuths, float* values);

  std::unique_ptr<skyline::GpuFilter> Gpu;
  std::unique_ptr<skyline::GpuShadowSource> Sweeps;
};

#endif
