// SPDX-License-Identifier: BSD-3-Clause
// The terrain, its light and its lamps in a renderer with a camera.
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

/// One terrain at two resolutions of its mesh: fine, and coarse while something moves.
class TerrainScene
{
public:
  /// Posts of the coarse mesh.
  static constexpr double CoarsePosts = 20000.0;

  /// Throws Failure if no cell of the terrain has all its posts.
  explicit TerrainScene(vtkImageData* heights);

  vtkRenderer* GetRenderer() const;
  vtkImageData* GetHeights() const;
  vtkSkylineSoftShadowShader* GetShader() const;

  /// Sets the light: the output of vtkHeightFieldShading for these heights or for some of their
  /// posts.
  void SetLight(vtkImageData* lit);
  SkyDome& GetSky() { return *this->Sky; }
  void SetExposure(double stops);
  void SetExaggeration(double factor);
  void SetCoarse(bool coarse);
  bool IsCoarse() const { return this->Coarse; }
  void SetLamps(const std::vector<ViewerLamp>& lamps);

  /// Shows the whole terrain, seen from an azimuth and an elevation in degrees.
  void ResetCamera(double azimuth, double elevation, double aspect);

  /// Moves the focus of the camera, about which it turns, to the ground in the middle of the
  /// picture. The picture does not change.
  void FocusOnGround();

  /// Prepares lamps, sky and depth for the camera. To be called before drawing.
  void Prepare();

  /// Finds the ground under a pixel. Returns false if there is none.
  bool FindPlace(double x, double y, ScenePoint& place) const;

  /// The unit vector of the direction in which the camera sees a pixel.
  ScenePoint GetDirection(double x, double y) const;

  /// The lamp under a pixel, or the number of lamps if there is none. `reach` is the radius around
  /// its middle in pixels.
  std::size_t FindLamp(double x, double y, double reach) const;

  /// The pixel of the ground below a lamp.
  ScenePoint GetFoot(const ViewerLamp& lamp) const;

  /// The direction of view, in degrees clockwise from grid north.
  double GetHeading() const;

  /// The width in metres that a pixel covers, on the ground in the middle of the picture or, if
  /// there is none, at the focus of the camera.
  double GetMetresPerPixel() const;

private:
  struct Mesh
  {
    vtkSmartPointer<vtkActor> Ground, Wall;
    vtkSmartPointer<vtkPoints> GroundPoints, WallPoints;
  };
  Mesh MakeMeshActors(double posts);
  ScenePoint CenterOf(const ViewerLamp& lamp) const;
  double MetresPerPixelAt(const ScenePoint& place) const;

  vtkSmartPointer<vtkImageData> Heights;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkSkylineSoftShadowPolyDataMapper> Mapper; ///< its shader serves all parts
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
