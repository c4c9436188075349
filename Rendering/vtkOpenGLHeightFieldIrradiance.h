// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLHeightFieldIrradiance
 * @brief   the light that falls on every post, computed by a graphics processor
 *
 * GPU counterpart of vtkHeightFieldIrradiance for LightMethod HARMONICS, its default: the same array
 * `Irradiance`, which differs by the rounding of floats (Documentation/gpu.md has the bounds). The
 * transfer of the posts stays there: a changed light costs one pass. Horizons are those of Method
 * PYRAMID or EXACT; FAST takes the exact ones.
 *
 * With ReadBack off nothing leaves the graphics processor: hand GetTexture to
 * vtkSoftShadowShader::SetIrradianceTexture of a mapper that draws in the device's window.
 *
 * The host computes TABLE, lamps (whose light it adds to what is read back), SWEEP and bilinear
 * surfaces. Where there is no OpenGL context, or it is lost, one error says so in one line and the host
 * computes all. IsOnDevice tells who did.
 */
#ifndef vtkOpenGLHeightFieldIrradiance_h
#define vtkOpenGLHeightFieldIrradiance_h

#include "SkylineRenderingModule.h" // For export macro
#include "vtkHeightFieldIrradiance.h"

#include <memory> // For Gpu

class vtkOpenGLHeightFieldDevice;
class vtkTextureObject;

class SKYLINERENDERING_EXPORT vtkOpenGLHeightFieldIrradiance : public vtkHeightFieldIrradiance
{
public:
  static vtkOpenGLHeightFieldIrradiance* New();
  vtkTypeMacro(vtkOpenGLHeightFieldIrradiance, vtkHeightFieldIrradiance);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Where to compute; default: a device of its own. Several filters may share one.
  void SetDevice(vtkOpenGLHeightFieldDevice* device);
  vtkOpenGLHeightFieldDevice* GetDevice();
  ///@}

  ///@{
  /// Whether to make the array; default on. Off, the array is made nevertheless for a height field that
  /// does not fit into one texture, and where lamps shine.
  vtkSetMacro(ReadBack, bool);
  vtkGetMacro(ReadBack, bool);
  vtkBooleanMacro(ReadBack, bool);
  ///@}

  /// Whether the graphics processor made the last result.
  bool IsOnDevice();

  /// The irradiance, a texel a post, without lamps; null if it is not there: after tiles, or after the
  /// host. Valid until the next update; the next frame of a field of this size fills the same one. Where
  /// posts are missing it means nothing.
  vtkTextureObject* GetTexture();

  ///@{
  /// Seconds of the last execution by pass, measured with MeasurePasses (default off; it makes the
  /// passes wait for each other): upload and pyramid, horizons, wedges, light, reading back.
  vtkSetMacro(MeasurePasses, bool);
  vtkGetMacro(MeasurePasses, bool);
  vtkBooleanMacro(MeasurePasses, bool);
  void GetPassSeconds(double seconds[5]);
  ///@}

  /// The device too.
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
  std::unique_ptr<Internals> Inside;
};

#endif
