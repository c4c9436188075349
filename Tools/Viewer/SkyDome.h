// SPDX-License-Identifier: BSD-3-Clause
// The sky behind the terrain, where the light says it is.
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

/// A sphere around the camera, behind everything, with the sky as its texture, and the sun's disc.
class SkyDome
{
public:
  /// The sky's typical luminance is shown at most so bright: a photographer's graduated filter,
  /// without which it would be white where the sky is most of the light.
  static constexpr float BrightestTypical = 0.4f;

  /// Adds itself to the renderer, behind nothing yet.
  explicit SkyDome(vtkRenderer* renderer);

  void SetSky(SkyImage sky);
  void SetRotation(double degrees); ///< clockwise, of the sky but not of the sun

  /// The sun's disc in a direction (degrees from grid north, degrees up), or none.
  void SetSun(bool on, double azimuth, double elevation, double radius);

  /// The picture at an exposure in stops, tone-mapped.
  void Develop(double stops);

  /// The codes of light over `peak`, as floats without a tone curve and without the sun's disc, until
  /// Develop.
  void DevelopLinear(float peak);

  const SkyImage& GetSky() const { return this->Sky; }

  /// Around the renderer's camera, whose far plane it moves back; after the near and far plane have
  /// been set for everything else.
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
  vtkSmartPointer<vtkFloatArray> Places; ///< of the sphere's corners in the texture
  vtkSmartPointer<vtkTexture> Texture;
};

} // namespace skyline

#endif
