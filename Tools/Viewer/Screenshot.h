// SPDX-License-Identifier: BSD-3-Clause
// What a window shows, as a file.
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

/// The first of skyline-1.png, skyline-2.png ... in the folder that is not there yet.
std::string FreeName(const std::string& folder, const std::string& extension);

/// The window's picture as it was drawn last, as a PNG. Throws Failure.
void WritePng(vtkRenderWindow* window, const std::string& file);

/// The renderer's view in linear light, before exposure and tone curve, as OpenEXR of 32-bit floats,
/// the sky without its sun's disc. Draws it. Throws Failure.
void WriteExr(vtkRenderWindow* window, vtkRenderer* renderer, vtkSkylineSoftShadowShader* shader,
  SkyDome& sky, const std::string& file);

} // namespace skyline

#endif
