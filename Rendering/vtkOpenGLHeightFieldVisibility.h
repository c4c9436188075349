// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLHeightFieldVisibility
 * @brief   the sky that every post sees, computed by a graphics processor
 *
 * GPU counterpart of vtkHeightFieldVisibility: the same array `VisibilitySH`, which differs by the rounding of floats
 * (Documentation/gpu.md has the bounds). Horizons are those of Method PYRAMID or EXACT; FAST takes the
 * exact ones. With ReadBack off no array is made: the coefficients stay in textures.
 *
 * Where there is no OpenGL context, or it is lost, one error says so in one line and the host computes
 * the array. SWEEP and bilinear surfaces the host computes anyway. IsOnDevice tells who did.
 */
#ifndef vtkOpenGLHeightFieldVisibility_h
#define vtkOpenGLHeightFieldVisibility_h

#include "SkylineRenderingModule.h" // For export macro
#include "vtkHeightFieldVisibility.h"

#include <memory> // For Gpu

namespace skyline
{
class GpuFilter;
}
class vtkOpenGLHeightFieldDevice;
class vtkTextureObject;

class SKYLINERENDERING_EXPORT vtkOpenGLHeightFieldVisibility : public vtkHeightFieldVisibility
{
public:
  static vtkOpenGLHeightFieldVisibility* New();
  vtkTypeMacro(vtkOpenGLHeightFieldVisibility, vtkHeightFieldVisibility);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Where to compute; default: a device of its own. Several filters may share one.
  void SetDevice(vtkOpenGLHeightFieldDevice* device);
  vtkOpenGLHeightFieldDevice* GetDevice();
  ///@}

  ///@{
  /// Whether to make the array; default on. Off, the height field must fit into one texture, or the
  /// array is made after all.
  vtkSetMacro(ReadBack, bool);
  vtkGetMacro(ReadBack, bool);
  vtkBooleanMacro(ReadBack, bool);
  ///@}

  /// Whether the graphics processor made the last result.
  bool IsOnDevice();

  /// Coefficients 4 index .. 4 index + 3 of every post, a texel each; null if they are not there: after
  /// tiles, or after the host. Valid until the next update. Where posts are missing they mean nothing.
  vtkTextureObject* GetTexture(int index);

  /// The device too.
  vtkMTimeType GetMTime() override;

protected:
  vtkOpenGLHeightFieldVisibility();
  ~vtkOpenGLHeightFieldVisibility() override;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;
  bool Sum(skyline::HorizonDriver& driver, const std::vector<double>& azimuths, double width,
    const float* east, const float* north, float* values) override;

private:
  vtkOpenGLHeightFieldVisibility(const vtkOpenGLHeightFieldVisibility&) = delete;
  void operator=(const vtkOpenGLHeightFieldVisibility&) = delete;

  bool ReadBack = true;
  std::unique_ptr<skyline::GpuFilter> Gpu;
};

#endif
