// SPDX-License-Identifier: BSD-3-Clause
// Draws the terrain of a figure with its light.
#ifndef skyline_Studio_h
#define skyline_Studio_h

#include "CameraFit.h"
#include "Picture.h"
#include "Reference/LampOracle.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkPoints;
class vtkRenderWindow;
VTK_ABI_NAMESPACE_END

namespace skyline
{
namespace gallery
{

/// The glowing ball of a lamp in the picture, in linear colour.
struct Bulb
{
  oracle::Ball Ball;
  std::array<double, 3> Color{ { 1.0, 1.0, 1.0 } };
};

/// The view of a terrain.
struct Look
{
  Standpoint From;
  int Width = 240, Height = 180;
  double Exposure = 0.0; ///< stops
  /// The western, eastern, southern and northern limits of the part in the picture, metres. Equal
  /// limits stand for the whole terrain.
  std::array<double, 4> Region{ {} };
  std::vector<Bulb> Bulbs;
};

/// Draws with vtkSkylineSoftShadowPolyDataMapper in an off-screen window.
class Studio
{
public:
  /// Returns false, and the reason, if there is no OpenGL.
  bool Open(std::string& reason);

  /// Draws the white terrain with an irradiance (three floats per post; pi is full light).
  Picture Draw(
    const oracle::OracleField& terrain, const std::vector<float>& irradiance, const Look& look);

  /// Draws actors, from a position at which the points are in the picture.
  Picture Draw(
    const std::vector<vtkSmartPointer<vtkActor>>& actors, vtkPoints* inside, const Look& look);

private:
  vtkSmartPointer<vtkRenderWindow> Window;
};

/// Uses the same value for red, green and blue.
std::vector<float> Grey(const std::vector<float>& light);

} // namespace gallery
} // namespace skyline

#endif
