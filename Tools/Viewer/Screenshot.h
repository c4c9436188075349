// SPDX-License-Identifier: BSD-3-Clause
// Writes the content of a window to a file.
#ifndef skyline_Screenshot_h
#define skyline_Screenshot_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;
class vtkRenderer;
class vtkSkylineSoftShadowShader;
VTK_ABI_NAMESPACE_END

namespace skyline
{

class SkyDome;

/// The first name of skyline-1.png, skyline-2.png ... that does not exist in the folder.
std::string FreeName(const std::string& folder, const std::string& extension);

/// Writes the last picture of the window as a PNG. Throws Failure.
void WritePng(vtkRenderWindow* window, const std::string& file);

/// Draws the view of the renderer in linear light, before exposure and tone curve, without the disc
/// of the sun, and writes it as OpenEXR of 32-bit floats. Throws Failure.
void WriteExr(vtkRenderWindow* window, vtkRenderer* renderer, vtkSkylineSoftShadowShader* shader,
  SkyDome& sky, const std::string& file);

} // namespace skyline

#endif
