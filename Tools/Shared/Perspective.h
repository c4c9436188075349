// SPDX-License-Identifier: BSD-3-Clause
// Draws a perspective view of the terrain.
#ifndef skyline_Perspective_h
#define skyline_Perspective_h

#include "RunPass.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <array>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace CLI
{
class App;
}

namespace skyline
{

/// --from, --size.
struct PerspectiveOptions
{
  std::string From = "180,35";
  std::string Size = "1600x1000";
  void AddTo(CLI::App& command);

  /// Converts the texts to numbers: pixels and degrees.
  void Read(int& width, int& height, double& azimuth, double& elevation) const;
};

/// What the picture shows besides the light on the terrain.
struct PerspectiveLight
{
  double Exposure = 0.0;                  ///< stops
  std::array<float, 3> SkyRadiance{ {} }; ///< for the background
};

/// Draws an image with the point arrays Elevation and Radiance, as vtkHeightFieldShading makes it.
/// The result has the point array Picture (RGBA). Throws Failure if OpenGL is not available.
vtkSmartPointer<vtkImageData> DrawPerspective(vtkImageData* terrain, const PerspectiveLight& light,
  const PerspectiveOptions& options, const CommonOptions& common);

} // namespace skyline

#endif
