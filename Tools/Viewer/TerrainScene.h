// SPDX-License-Identifier: BSD-3-Clause
// The terrain, its light and its lamps in a renderer, with a camera.
#ifndef skyline_TerrainScene_h
#define skyline_TerrainScene_h

#include "Color/ToneMap.h"
#include "HeightRay.h"
#include "SkyDome.h"
#include "ViewerState.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkImageData;
class vtkPoints;
class vtkRenderer;
class vtkSkylineSoftShadowPolyDataMapper;
class vtkSkylineSoftShadowShader;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// One terrain at two resolutions of its mesh: fine, and coarse for as long as something moves.
class TerrainScene
{
public:
  /// Posts of the coarse mesh.
  static constexpr double CoarsePosts = 20000.0;

  /// Throws Failure where no cell of the terrain has all its posts.
  explicit TerrainScene(vtkImageData* heights);

  vtkRenderer* GetRenderer() const;
  vtkImageData* GetHeights() const;
  vtkSkylineSoftShadowShader* GetShader() const;

  /// What vtkHeightFieldShading made of these heights, or of some of their posts.
  void SetLight(vtkImageData* lit);
  SkyDome& GetSky() { return *this->Sky; }
  void SetExposure(double stops);
  void SetExaggeration(double factor);
  void SetCoarse(bool coarse);
  bool IsCoarse() const { return this->Coarse; }
  void SetLamps(const std::vector<ViewerLamp>& lamps);

  /// All of the terrain in the picture, seen from azimuth and elevation in degrees.
  void ResetCamera(double azimuth, double elevation, double aspect);

  /// The camera's focus, about which it turns, to the ground in the middle of the picture, which stays.
  void FocusOnGround();

  /// Before drawing: lamps, sky and depth as the camera sees them.
  void Prepare();

  /// The ground under a pixel; false beside it.
  bool FindPlace(double x, double y, ScenePoint& place) const;

  /// The unit vector in which the camera sees a pixel.
  ScenePoint GetDirection(double x, double y) const;

  /// The lamp under a pixel, or the number of lamps; `reach` in pixels around its middle.
  std::size_t FindLamp(double x, double y, double reach) const;

  /// The pixel of the ground under a lamp.
  ScenePoint GetFoot(const ViewerLamp& lamp) const;

  /// Degrees clockwise from grid north, in which the camera looks.
  double GetHeading() const;

  /// Metres across that a pixel shows of the ground in the middle of the picture, or, beside the
  /// ground, at the camera's focus.
  double GetMetresAPixel() const;

private:
  struct Mesh
  {
    vtkSmartPointer<vtkActor> Ground, Wall;
    vtkSmartPointer<vtkPoints> GroundPoints, WallPoints;
  };
  Mesh MakeMeshActors(double posts);
  ScenePoint CenterOf(const ViewerLamp& lamp) const;
  double MetresAPixelAt(const ScenePoint& place) const;

  vtkSmartPointer<vtkImageData> Heights;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkSkylineSoftShadowPolyDataMapper> Mapper; ///< its shader serves all
  Mesh FineMesh, CoarseMesh;
  std::vector<vtkSmartPointer<vtkActor>> Balls;
  std::vector<ViewerLamp> Lamps;
  std::unique_ptr<SkyDome> Sky;
  double Stops = 0.0;
  double Exaggeration = 1.0;
  bool Coarse = false;
};

} // namespace skyline

#endif
