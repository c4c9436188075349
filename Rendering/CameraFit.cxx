// SPDX-License-Identifier: BSD-3-Clause
#include "CameraFit.h"

#include "Shared/Constants.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{

using Vector = std::array<double, 3>;

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The limits that the points set to the position of the camera in one plane.
struct Sides
{
  double Tangent;
  double Plus = -std::numeric_limits<double>::infinity();
  double Minus = -std::numeric_limits<double>::infinity();

  void Add(double u, double w)
  {
    this->Plus = std::max(this->Plus, u - this->Tangent * w);
    this->Minus = std::max(this->Minus, -u - this->Tangent * w);
  }
  double Depth() const { return 0.5 * (this->Plus + this->Minus) / this->Tangent; }
  double Offset() const { return 0.5 * (this->Plus - this->Minus); }
};

} // namespace

namespace skyline
{

void FitCamera(
  vtkCamera* camera, const std::vector<vtkPoints*>& points, const Standpoint& standpoint)
{
  const auto some = std::find_if(
    points.begin(), points.end(), [](vtkPoints* group) { return group->GetNumberOfPoints() > 0; });
  if (some == points.end())
  {
    return;
  }
  const double azimuth = standpoint.Azimuth * RadiansPerDegree;
  const double elevation = standpoint.Elevation * RadiansPerDegree;
  const Vector right{ { -std::cos(azimuth), std::sin(azimuth), 0.0 } };
  const Vector away{ { -std::sin(azimuth) * std::cos(elevation),
    -std::cos(azimuth) * std::cos(elevation), -std::sin(elevation) } };
  Vector up;
  vtkMath::Cross(right.data(), away.data(), up.data());

  const double half = std::tan(0.5 * standpoint.ViewAngle * RadiansPerDegree) * standpoint.Filled;
  Sides across{ half * standpoint.Aspect };
  Sides upright{ half };
  Vector origin; // the first point: relative coordinates keep their digits far from the origin
  (*some)->GetPoint(0, origin.data());
  for (vtkPoints* group : points)
  {
    for (vtkIdType i = 0; i < group->GetNumberOfPoints(); ++i)
    {
      Vector p;
      group->GetPoint(i, p.data());
      vtkMath::Subtract(p.data(), origin.data(), p.data());
      across.Add(Dot(p, right), Dot(p, away));
      upright.Add(Dot(p, up), Dot(p, away));
    }
  }
  const double back = std::max(across.Depth(), upright.Depth());
  Vector eye;
  Vector target;
  for (std::size_t k = 0; k < 3; ++k)
  {
    eye[k] = origin[k] + across.Offset() * right[k] + upright.Offset() * up[k] - back * away[k];
    target[k] = eye[k] + std::max(back, 1.0e-9) * away[k];
  }
  camera->SetViewAngle(standpoint.ViewAngle);
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(target.data());
  camera->SetViewUp(up.data());
}

} // namespace skyline
