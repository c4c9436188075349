// SPDX-License-Identifier: BSD-3-Clause
#include "TerrainScene.h"

#include "CameraFit.h"
#include "Failure.h"
#include "Shared/Constants.h"
#include "TerrainActors.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkHeightFieldSurface.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSkylineSoftShadowPolyDataMapper.h"
#include "vtkSkylineSoftShadowShader.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>

namespace
{

/// Least width of a lamp in pixels, so that the user can find it.
constexpr double LeastLampPixels = 5.0;

vtkSmartPointer<vtkPoints> Stretched(vtkPoints* points, double factor)
{
  auto stretched = vtkSmartPointer<vtkPoints>::New();
  stretched->SetDataTypeToDouble();
  stretched->SetNumberOfPoints(points->GetNumberOfPoints());
  for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k)
  {
    double point[3];
    points->GetPoint(k, point);
    stretched->SetPoint(k, point[0], point[1], factor * point[2]);
  }
  return stretched;
}

skyline::ScenePoint Project(vtkRenderer* renderer, const skyline::ScenePoint& place)
{
  renderer->SetWorldPoint(place[0], place[1], place[2], 1.0);
  renderer->WorldToDisplay();
  const double* pixel = renderer->GetDisplayPoint();
  return { { pixel[0], pixel[1], pixel[2] } };
}

skyline::ScenePoint Unproject(vtkRenderer* renderer, double x, double y, double depth)
{
  renderer->SetDisplayPoint(x, y, depth);
  renderer->DisplayToWorld();
  const double* point = renderer->GetWorldPoint();
  return { { point[0] / point[3], point[1] / point[3], point[2] / point[3] } };
}

} // namespace

namespace skyline
{

TerrainScene::TerrainScene(vtkImageData* heights)
  : Heights(heights)
  , Renderer(vtkSmartPointer<vtkRenderer>::New())
  , FineMesh(this->MakeMeshActors(MostMeshPosts))
  , CoarseMesh(this->MakeMeshActors(CoarsePosts))
{
  this->SetCoarse(false);
  this->Sky = std::make_unique<SkyDome>(this->Renderer); // last, since most of it is hidden
}

TerrainScene::Mesh TerrainScene::MakeMeshActors(double posts)
{
  const auto surface = MakeMesh(this->Heights, posts);
  surface->Update();
  vtkPolyData* mesh = surface->GetOutput();
  if (mesh->GetNumberOfCells() == 0)
  {
    throw Failure("every cell of the terrain has a missing post: there is nothing to see");
  }
  const auto skirt = MakeSkirt(this->Heights, posts, mesh);
  skirt->Update();
  const auto mapper = MakeMapper(surface, this->Heights, 0.0);
  const auto wall = MakeMapper(skirt, this->Heights, 0.0);
  if (!this->Mapper)
  {
    this->Mapper = mapper;
  }
  mapper->SetShader(this->Mapper->GetShader());
  wall->SetShader(this->Mapper->GetShader());
  Mesh made{ MakeActor(mapper, 1.0), MakeActor(wall, SkirtColor), mesh->GetPoints(),
    skirt->GetOutput()->GetPoints() };
  this->Renderer->AddActor(made.Ground);
  this->Renderer->AddActor(made.Wall);
  return made;
}

vtkRenderer* TerrainScene::GetRenderer() const
{
  return this->Renderer;
}

vtkImageData* TerrainScene::GetHeights() const
{
  return this->Heights;
}

vtkSkylineSoftShadowShader* TerrainScene::GetShader() const
{
  return this->Mapper->GetShader();
}

void TerrainScene::SetLight(vtkImageData* lit)
{
  this->GetShader()->SetHeightField(lit);
}

void TerrainScene::SetExposure(double stops)
{
  this->Stops = stops;
  this->GetShader()->SetExposure(ShaderExposure(stops));
}

void TerrainScene::SetExaggeration(double factor)
{
  this->Exaggeration = factor;
  for (const Mesh* mesh : { &this->FineMesh, &this->CoarseMesh })
  {
    mesh->Ground->SetScale(1.0, 1.0, factor);
    mesh->Wall->SetScale(1.0, 1.0, factor);
  }
}

void TerrainScene::SetCoarse(bool coarse)
{
  this->Coarse = coarse;
  this->FineMesh.Ground->SetVisibility(!coarse);
  this->FineMesh.Wall->SetVisibility(!coarse);
  this->CoarseMesh.Ground->SetVisibility(coarse);
  this->CoarseMesh.Wall->SetVisibility(coarse);
}

ScenePoint TerrainScene::CenterOf(const ViewerLamp& lamp) const
{
  const double ground = GroundOrZero(this->Heights, this->Exaggeration, lamp.X, lamp.Y);
  return { { lamp.X, lamp.Y, ground + lamp.Height } };
}

void TerrainScene::SetLamps(const std::vector<ViewerLamp>& lamps)
{
  while (this->Balls.size() > lamps.size())
  {
    this->Renderer->RemoveActor(this->Balls.back());
    this->Balls.pop_back();
  }
  while (this->Balls.size() < lamps.size())
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(1.0);
    ball->SetThetaResolution(24);
    ball->SetPhiResolution(16);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetAmbient(1.0);
    actor->GetProperty()->SetDiffuse(0.0);
    this->Renderer->AddActor(actor);
    this->Balls.push_back(actor);
  }
  this->Lamps = lamps;
}

void TerrainScene::Prepare()
{
  for (std::size_t k = 0; k < this->Lamps.size(); ++k)
  {
    const ViewerLamp& lamp = this->Lamps[k];
    const ScenePoint center = this->CenterOf(lamp);
    const double peak = std::max({ lamp.Radiance[0], lamp.Radiance[1], lamp.Radiance[2], 1.0e-30 });
    this->Balls[k]->SetPosition(center[0], center[1], center[2]);
    this->Balls[k]->SetScale(
      std::max(lamp.Radius, 0.5 * LeastLampPixels * this->MetresPerPixelAt(center)));
    vtkProperty* look = this->Balls[k]->GetProperty();
    look->SetColor(EncodeSrgb(static_cast<float>(lamp.Radiance[0] / peak)),
      EncodeSrgb(static_cast<float>(lamp.Radiance[1] / peak)),
      EncodeSrgb(static_cast<float>(lamp.Radiance[2] / peak)));
  }
  this->Renderer->ResetCameraClippingRange();
  this->Sky->Develop(this->Stops);
  this->Sky->Surround();
}

void TerrainScene::ResetCamera(double azimuth, double elevation, double aspect)
{
  Standpoint standpoint;
  standpoint.Azimuth = azimuth;
  standpoint.Elevation = elevation;
  standpoint.Aspect = aspect;
  const auto ground = Stretched(this->CoarseMesh.GroundPoints, this->Exaggeration);
  const auto wall = Stretched(this->CoarseMesh.WallPoints, this->Exaggeration);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  FitCamera(camera, { ground, wall }, standpoint);
  if (elevation < 90.0)
  {
    camera->SetViewUp(0.0, 0.0, 1.0); // the camera turns about the vertical
  }
  this->FocusOnGround();
  this->Prepare();
}

void TerrainScene::FocusOnGround()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double* eye = camera->GetPosition();
  const double* look = camera->GetDirectionOfProjection();
  const auto along = [&](double way)
  {
    return ScenePoint{ { eye[0] + way * look[0], eye[1] + way * look[1], eye[2] + way * look[2] } };
  };
  const double* bounds = this->Heights->GetBounds();
  const double across = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  ScenePoint place;
  if (FindGround(this->Heights, this->Exaggeration, along(0.0),
        along(2.0 * (camera->GetDistance() + across)), place))
  {
    const double depth =
      (place[0] - eye[0]) * look[0] + (place[1] - eye[1]) * look[1] + (place[2] - eye[2]) * look[2];
    const ScenePoint focus = along(depth);
    camera->SetFocalPoint(focus.data());
  }
}

bool TerrainScene::FindPlace(double x, double y, ScenePoint& place) const
{
  return FindGround(this->Heights, this->Exaggeration, Unproject(this->Renderer, x, y, 0.0),
    Unproject(this->Renderer, x, y, 1.0), place);
}

ScenePoint TerrainScene::GetDirection(double x, double y) const
{
  const double* eye = this->Renderer->GetActiveCamera()->GetPosition();
  ScenePoint look = Unproject(this->Renderer, x, y, 0.5);
  double length = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    look[k] -= eye[k];
    length = std::hypot(length, look[k]);
  }
  return { { look[0] / length, look[1] / length, look[2] / length } };
}

std::size_t TerrainScene::FindLamp(double x, double y, double reach) const
{
  std::size_t nearest = this->Lamps.size();
  double least = 0.0;
  for (std::size_t k = 0; k < this->Lamps.size(); ++k)
  {
    const ScenePoint center = this->CenterOf(this->Lamps[k]);
    const ScenePoint pixel = Project(this->Renderer, center);
    const ScenePoint beside = Unproject(this->Renderer, pixel[0] + 1.0, pixel[1], pixel[2]);
    const double metres =
      std::hypot(beside[0] - center[0], std::hypot(beside[1] - center[1], beside[2] - center[2]));
    const double seen = std::max(reach, this->Lamps[k].Radius / std::max(metres, 1.0e-30));
    const double distance = std::hypot(pixel[0] - x, pixel[1] - y);
    if (pixel[2] <= 1.0 && distance <= seen && (nearest == this->Lamps.size() || distance < least))
    {
      nearest = k;
      least = distance;
    }
  }
  return nearest;
}

ScenePoint TerrainScene::GetFoot(const ViewerLamp& lamp) const
{
  const double ground = GroundOrZero(this->Heights, this->Exaggeration, lamp.X, lamp.Y);
  return Project(this->Renderer, { { lamp.X, lamp.Y, ground } });
}

double TerrainScene::GetHeading() const
{
  const double* look = this->Renderer->GetActiveCamera()->GetDirectionOfProjection();
  const double* up = this->Renderer->GetActiveCamera()->GetViewUp();
  const bool down = std::hypot(look[0], look[1]) < 1.0e-6;
  const double* ahead = down ? up : look;
  const double heading = std::atan2(ahead[0], ahead[1]) / RadiansPerDegree;
  return heading < 0.0 ? heading + 360.0 : heading;
}

double TerrainScene::MetresPerPixelAt(const ScenePoint& place) const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double* eye = camera->GetPosition();
  const double* look = camera->GetDirectionOfProjection();
  const double depth =
    (place[0] - eye[0]) * look[0] + (place[1] - eye[1]) * look[1] + (place[2] - eye[2]) * look[2];
  const int* size = this->Renderer->GetSize();
  return 2.0 * std::max(depth, 0.0) * std::tan(0.5 * camera->GetViewAngle() * RadiansPerDegree) /
    std::max(size[1], 1);
}

double TerrainScene::GetMetresPerPixel() const
{
  const int* size = this->Renderer->GetSize();
  ScenePoint place;
  if (!this->FindPlace(0.5 * size[0], 0.5 * size[1], place))
  {
    this->Renderer->GetActiveCamera()->GetFocalPoint(place.data());
  }
  return this->MetresPerPixelAt(place);
}

} // namespace skyline
