// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLHeightFieldTransfer
 * @brief   how each post turns distant light into irradiance, computed by a graphics processor
 *
 * GPU counterpart of vtkHeightFieldTransfer with the same array `TransferSH`. The values differ by
 * the rounding of floats; Documentation/gpu.md gives the bounds. Horizons are those of the Method
 * PYRAMID or EXACT; FAST uses the exact ones. With ReadBack off no array is made, and the
 * coefficients stay in textures.
 *
 * If there is no OpenGL context, or if it is lost, the filter reports one error of one line and the
 * host computes the array. The host also computes SWEEP and bilinear surfaces, without an error.
 * IsOnDevice returns which of the two computed.
 */
#ifndef vtkOpenGLHeightFieldTransfer_h
#define vtkOpenGLHeightFieldTransfer_h

#include "SkylineRenderingModule.h" // For export macro
#include "vtkHeightFieldTransfer.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <memory> // For Gpu

namespace skyline
{
class GpuFilter;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLHeightFieldDevice;
class vtkTextureObject;

class SKYLINERENDERING_EXPORT vtkOpenGLHeightFieldTransfer : public vtkHeightFieldTransfer
{
public:
  static vtkOpenGLHeightFieldTransfer* New();
  vtkTypeMacro(vtkOpenGLHeightFieldTransfer, vtkHeightFieldTransfer);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The device on which to compute. Default: a device of this filter alone. Several filters can
  /// share a device.
  void SetDevice(vtkOpenGLHeightFieldDevice* device);
  vtkOpenGLHeightFieldDevice* GetDevice();
  ///@}

  ///@{
  /// Whether to make the array. Default: on. If off, the array is made nevertheless if the height
  /// field does not fit into one texture.
  vtkSetMacro(ReadBack, bool);
  vtkGetMacro(ReadBack, bool);
  vtkBooleanMacro(ReadBack, bool);
  ///@}

  /// Returns whether the graphics processor computed the last result.
  bool IsOnDevice();

  /// Returns a texture with the coefficients 4 index to 4 index + 3 of each post, one texel per
  /// post, or null if the field was computed in tiles or by the host. The texture is valid until
  /// the next update. Texels of missing posts have no meaning.
  vtkTextureObject* GetTexture(int index);

  /// The modified time, including that of the device.
  vtkMTimeType GetMTime() override;

protected:
  vtkOpenGLHeightFieldTransfer();
  ~vtkOpenGLHeightFieldTransfer() override;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;
  bool Sum(skyline::HorizonDriver& driver, const std::vector<double>& azimuths, double width,
    const float* east, const float* north, float* values) override;

private:
  vtkOpenGLHeightFieldTransfer(const vtkOpenGLHeightFieldTransfer&) = delete;
  void operator=(const vtkOpenGLHeightFieldTransfer&) = delete;

  bool ReadBack = true;
  std::unique_ptr<skyline::GpuFilter> Gpu;
};
VTK_ABI_NAMESPACE_END

#endif
