// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLHeightFieldIrradiance
 * @brief   the light that falls on each post, computed by a graphics processor
 *
 * GPU counterpart of vtkHeightFieldIrradiance for the LightMethod HARMONICS, which is its default,
 * with the same array `Irradiance`. The values differ by the rounding of floats;
 * Documentation/gpu.md gives the bounds. The transfer of the posts stays on the graphics processor,
 * so that a change of the lights takes one pass. Horizons are those of the Method PYRAMID or EXACT;
 * FAST uses the exact ones.
 *
 * With ReadBack off, the result stays on the graphics processor: pass GetTexture to
 * vtkSkylineSoftShadowShader::SetIrradianceTexture of a mapper that draws in the window of the
 * device.
 *
 * The host computes the LightMethod TABLE, the Method SWEEP and bilinear surfaces. It also computes
 * lamps, and adds their light to the array. If there is no OpenGL context, or if it is lost, the
 * filter reports one error of one line and the host computes everything. IsOnDevice returns which
 * of the two computed.
 */
#ifndef vtkOpenGLHeightFieldIrradiance_h
#define vtkOpenGLHeightFieldIrradiance_h

#include "SkylineRenderingModule.h" // For export macro
#include "vtkHeightFieldIrradiance.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <memory> // For Gpu

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLHeightFieldDevice;
class vtkTextureObject;

class SKYLINERENDERING_EXPORT vtkOpenGLHeightFieldIrradiance : public vtkHeightFieldIrradiance
{
public:
  static vtkOpenGLHeightFieldIrradiance* New();
  vtkTypeMacro(vtkOpenGLHeightFieldIrradiance, vtkHeightFieldIrradiance);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The device on which to compute. Default: a device of this filter alone. Several filters can
  /// share a device.
  void SetDevice(vtkOpenGLHeightFieldDevice* device);
  vtkOpenGLHeightFieldDevice* GetDevice();
  ///@}

  ///@{
  /// Whether to make the array. Default: on. If off, the array is made nevertheless if the height
  /// field does not fit into one texture or if there are lamps.
  vtkSetMacro(ReadBack, bool);
  vtkGetMacro(ReadBack, bool);
  vtkBooleanMacro(ReadBack, bool);
  ///@}

  /// Returns whether the graphics processor computed the last result.
  bool IsOnDevice();

  /// Returns the irradiance without lamps, one texel per post, or null if the field was computed in
  /// tiles or by the host. The texture is valid until the next update, which fills the same texture
  /// if the size stays the same. Texels of missing posts have no meaning.
  vtkTextureObject* GetTexture();

  ///@{
  /// Seconds that each pass of the last execution took: 0 upload and pyramid, 1 horizons, 2 wedges,
  /// 3 light, 4 reading back. They are measured if MeasurePasses is on. Default: off, because the
  /// passes must then wait for each other.
  vtkSetMacro(MeasurePasses, bool);
  vtkGetMacro(MeasurePasses, bool);
  vtkBooleanMacro(MeasurePasses, bool);
  void GetPassSeconds(double seconds[5]);
  ///@}

  /// The modified time, including that of the device.
  vtkMTimeType GetMTime() override;

protected:
  vtkOpenGLHeightFieldIrradiance();
  ~vtkOpenGLHeightFieldIrradiance() override;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;
  bool LightByHarmonics(skyline::HorizonDriver& driver, const skyline::HarmonicLight& light,
    const std::vector<double>& key, const skyline::LitPosts& posts) override;

private:
  vtkOpenGLHeightFieldIrradiance(const vtkOpenGLHeightFieldIrradiance&) = delete;
  void operator=(const vtkOpenGLHeightFieldIrradiance&) = delete;

  bool HasLamps();

  struct Internals;
  bool ReadBack = true;
  bool MeasurePasses = false;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
