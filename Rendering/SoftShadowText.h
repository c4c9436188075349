// SPDX-License-Identifier: BSD-3-Clause
// The code that vtkSkylineSoftShadowShader inserts into the shaders of VTK's mappers.
#ifndef skyline_SoftShadowText_h
#define skyline_SoftShadowText_h

#include "vtkShader.h"

#include <map>
#include <string>

namespace skyline
{

/// The settings on which this code depends. vtkSkylineSoftShadowShader explains them.
struct SoftShadowText
{
  std::string Irradiance; ///< functions of the mode: a file of glsl/
  bool Lamps = false;
  bool ToneMapping = false;
  bool LinearTextures = false;
  bool LinearFramebuffer = false;
};

/// Inserts the code at VTK's markers. The markers stay, because VTK replaces them later.
void AddSoftShadows(
  const std::map<vtkShader::Type, vtkShader*>& shaders, const SoftShadowText& wanted);

} // namespace skyline

#endif
