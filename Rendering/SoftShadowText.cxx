// SPDX-License-Identifier: BSD-3-Clause
#include "SoftShadowText.h"

#include "Color/ToneMap.h"
#include "ShaderText.h"

#include "vtkShaderProgram.h"

#include <sstream>

namespace skyline
{

namespace
{

std::string Define(const char* name, const std::string& value)
{
  return std::string("#define ") + name + " " + value + "\n";
}

std::string Define(const char* name, float value)
{
  std::ostringstream text;
  text.precision(9);
  text << std::showpoint << value;
  return Define(name, text.str());
}

std::string ToneDefines()
{
  return Define("SKYLINE_TONE_GREY", ToneGrey) + Define("SKYLINE_TONE_CONTRAST", ToneContrast) +
    Define("SKYLINE_TONE_KNEE", ToneKnee) + Define("SKYLINE_TONE_WHITE", ToneWhite);
}

// Inserts text after a marker of VTK. The marker stays, because VTK replaces it later.
void AddAfter(vtkShader* shader, const std::string& marker, const std::string& text)
{
  vtkShaderProgram::Substitute(shader, marker, marker + "\n" + text);
}

} // namespace

void AddSoftShadows(
  const std::map<vtkShader::Type, vtkShader*>& shaders, const SoftShadowText& wanted)
{
  vtkShader* vertex = shaders.at(vtkShader::Vertex);
  AddAfter(vertex, "//VTK::PositionVC::Dec", ShaderPart(skyline_SoftShadowVS));
  AddAfter(vertex, "//VTK::PositionVC::Impl", ShaderPart(skyline_SoftShadowVS, "Impl"));
  vtkShader* geometry = shaders.at(vtkShader::Geometry);
  AddAfter(geometry, "//VTK::PositionVC::Dec", ShaderPart(skyline_SoftShadowGS));
  AddAfter(geometry, "//VTK::PositionVC::Impl", ShaderPart(skyline_SoftShadowGS, "Impl"));

  const bool decodes = !wanted.LinearTextures;
  std::string functions = Define("SKYLINE_COLOR(c)", decodes ? "c" : "SkylineDecode(c)") +
    Define("SKYLINE_ALBEDO(c)", decodes ? "SkylineDecode(c)" : "c") + ShaderPart(skyline_Srgb);
  std::string developed = "c";
  if (wanted.ToneMapping)
  {
    functions += ToneDefines() + ShaderPart(skyline_ToneMap);
    developed = "SkylineToneMap(c)";
  }
  if (!wanted.LinearFramebuffer)
  {
    developed = "SkylineEncode(" + developed + ")";
  }
  functions += Define("SKYLINE_DEVELOP(c)", developed);
  functions += wanted.Irradiance;
  std::string lamps;
  if (wanted.Lamps)
  {
    functions += ShaderPart(skyline_Lamps);
    lamps = ShaderPart(skyline_Lamps, "Impl");
  }
  std::string declared = ShaderPart(skyline_SoftShadowFS);
  vtkShaderProgram::Substitute(declared, "//Fill::Functions\n", functions);
  std::string light = ShaderPart(skyline_SoftShadowFS, "Impl");
  vtkShaderProgram::Substitute(light, "  //Fill::Lamps\n", lamps);
  vtkShader* fragment = shaders.at(vtkShader::Fragment);
  AddAfter(fragment, "//VTK::Color::Dec", declared);
  AddAfter(fragment, "//VTK::Light::Impl", ShaderPart(skyline_SoftShadowFS, "Color"));
  AddAfter(fragment, "//VTK::TCoord::Impl", light);
}

} // namespace skyline
