// SPDX-License-Identifier: BSD-3-Clause
// The terrain as a viewer sees it who stands beside it.
#ifndef skyline_Perspective_h
#define skyline_Perspective_h

#include "Passes.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <CLI/CLI.hpp>

#include <array>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// --from, --size.
struct PerspectiveOptions
{
  std::string From = "180,35";
  std::string Size = "1600x1000";
  void AddTo(CLI::App& command);

  /// The texts as numbers: pixels, degrees.
  void Read(int& width, int& height, double& azimuth, double& elevation) const;
};

/// What the picture shows beside the terrain's own light.
struct PerspectiveLight
{
  double Exposure = 0.0;                  ///< stops
  std::array<float, 3> SkyRadiance{ {} }; ///< for the background
};

/// A picture (the point array Picture, RGBA) of an image with the point arrays Elevation and Radiance, as
/// vtkHeightFieldShading makes it. Throws Failure where OpenGL cannot be had.
vtkSmartPointer<vtkImageData> DrawPerspective(vtkImageData* terrain, const PerspectiveLight& light,
  const PerspectiveOptions& options, const Talk& talk);

} // namespace skyline

#endif
