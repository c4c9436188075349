// SPDX-License-Identifier: BSD-3-Clause
// The sky behind the terrain, as the light describes it.
#ifndef skyline_SkyDome_h
#define skyline_SkyDome_h

#include "Color/ToneMap.h"
#include "SkyImage.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkDataArray;
class vtkFloatArray;
class vtkRenderer;
class vtkTexture;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// A sphere around the camera, behind everything else, with the sky as its texture, and the sun's
/// disc.
class SkyDome
{
public:
  /// Greatest brightness at which the typical luminance of the sky is shown, like a graduated
  /// filter in photography. Without it the sky would be white where it is most of the light.
  static constexpr float BrightestTypical = 0.4f;

  /// Adds itself to the renderer, without a sky.
  explicit SkyDome(vtkRenderer* renderer);

  void SetSky(SkyImage sky);
  void SetRotation(double degrees); ///< clockwise; turns the sky, but not the sun

  /// Shows the sun's disc in a direction (degrees from grid north, degrees of elevation), or hides
  /// it.
  void SetSun(bool on, double azimuth, double elevation, double radius);

  /// Makes the picture of the sky at an exposure in stops, tone-mapped.
  void Develop(double stops);

  /// Makes a picture of light divided by `peak`, as floats without tone curve and without the sun's
  /// disc, until Develop is called.
  void DevelopLinear(float peak);

  const SkyImage& GetSky() const { return this->Sky; }

  /// Places the sphere around the camera of the renderer and moves the far plane behind it. To be
  /// called after the near and far plane were set for everything else.
  void Surround();

private:
  void Show(vtkDataArray* pixels);

  vtkRenderer* Renderer;
  SkyImage Sky;
  double Stops = 0.0;
  bool Developed = false;
  bool SunOn = false;
  double SunAzimuth = 0.0, SunElevation = 0.0, SunRadius = 0.0;
  vtkSmartPointer<vtkActor> Dome, Sun;
  vtkSmartPointer<vtkFloatArray> Places; ///< of the corners of the sphere in the texture
  vtkSmartPointer<vtkTexture> Texture;
};

} // namespace skyline

#endif
