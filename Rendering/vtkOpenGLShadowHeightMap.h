// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLShadowHeightMap
 * @brief   the height of the terrain's shadow over each post, computed by a graphics processor
 *
 * GPU counterpart of vtkShadowHeightMap with the same settings and arrays. The values differ by the
 * rounding of floats; all heights are 32-bit floats. The height field must fit into one texture.
 *
 * - EXACT and FAST follow each ray, in a fragment shader, until the ray is above the highest post.
 * - SWEEP, the recurrence of Lee & Kim, needs compute shaders (OpenGL 4.3). Each work group
 *   processes a section of a line in shared memory, 64 lines per run. Without compute shaders the
 *   host computes, without an error.
 *
 * If there is no OpenGL context, or if a pass fails, the filter reports one error of one line and
 * the host computes the array. IsOnDevice returns which of the two computed.
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
  vtkOpenGLShadowHeightMap();
  ~vtkOpenGLShadowHeightMap() override;

  bool Compute(skyline::HorizonScene& scene, vtkImageData* output) override;

#ifndef __VTK_WRAP__
  std::unique_ptr<skyline::HorizonMethod> MakeMethod(
    skyline::HorizonScene& scene, double slope) override;
#endif

private:
  vtkOpenGLShadowHeightMap(const vtkOpenGLShadowHeightMap&) = delete;
  void operator=(const vtkOpenGLShadowHeightMap&) = delete;

  vtkSmartPointer<vtkOpenGLHeightFieldDevice> Device;
  std::unique_ptr<skyline::GpuShadowSource> Source;
  skyline::GpuShadows* Passes = nullptr; // during the execution
};

#endif
