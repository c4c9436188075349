// SPDX-License-Identifier: BSD-3-Clause
// Where the terrain of a figure is drawn in its light.
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

/// A lamp's glowing ball in the picture, linear colour.
struct Bulb
{
  oracle::Ball Ball;
  std::array<double, 3> Color{ { 1.0, 1.0, 1.0 } };
};

/// How a terrain is looked at.
struct Look
{
  Standpoint From;
  int Width = 240, Height = 180;
  double Exposure = 0.0; ///< stops
  /// West, east, south and north ends of what the picture is to hold, metres; equal: all.
  std::array<double, 4> Region{ {} };
  std::vector<Bulb> Bulbs;
};

/// Draws with vtkSkylineSoftShadowPolyDataMapper in a window that nobody sees.
class Studio
{
public:
  /// False, with the reason, where there is no OpenGL.
  bool Open(std::string& reason);

  /// The white terrain under an irradiance (three floats a post, pi: fully lit).
  Picture Draw(
    const oracle::OracleField& terrain, const std::vector<float>& irradiance, const Look& look);

  /// Actors, from where the points are in the picture.
  Picture Draw(
    const std::vector<vtkSmartPointer<vtkActor>>& actors, vtkPoints* inside, const Look& look);

private:
  vtkSmartPointer<vtkRenderWindow> Window;
};

/// The same value for red, green and blue.
std::vector<float> Grey(const std::vector<float>& light);

} // namespace gallery
} // namespace skyline

#endif
