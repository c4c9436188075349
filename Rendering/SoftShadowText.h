// SPDX-License-Identifier: BSD-3-Clause
// The patch of vtkSkylineSoftShadowShader to the shaders of VTK's mappers.
#ifndef skyline_SoftShadowText_h
#define skyline_SoftShadowText_h

#include "vtkShader.h"

#include <map>
#include <string>

namespace skyline
{

/// What the patch depends on; vtkSkylineSoftShadowShader says what each means.
struct SoftShadowText
{
  std::string Irradiance; ///< functions of the mode: a file of glsl/
  bool Lamps = false;
  bool ToneMapping = false;
  bool LinearTextures = false;
  bool LinearFramebuffer = false;
};

/// Puts the patch at VTK's markers, which stay for VTK.
void AddSoftShadows(
  const std::map<vtkShader::Type, vtkShader*>& shaders, const SoftShadowText& wanted);

} // namespace skyline

#endif
