// SPDX-License-Identifier: BSD-3-Clause
#include "ReceiverLight.h"

#include "ShaderText.h"
#include "ShadowHeight/ShadowHeightPenumbra.h"
#include "Shared/Constants.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace skyline
{

namespace
{

// As a part of the range of shadow heights: ten times the rounding error of their interpolation and
// of the mesh.
constexpr double SlackPart = 1.0e-6;

vtkDataArray* Find(vtkImageData* image, const char* name)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == 1 &&
      array->GetNumberOfTuples() == image->GetNumberOfPoints()
    ? array
    : nullptr;
}

void AddAfter(vtkShader* shader, const std::string& marker, const std::string& text)
{
  vtkShaderProgram::Substitute(shader, marker, marker + "\n" + text);
}

} // namespace

std::string ReceiverLight::Prepare(vtkOpenGLRenderWindow* window, vtkImageData* image, int& uploads)
{
  vtkDataArray* sun = image->GetFieldData()->GetArray("ShadowSun");
  vtkDataArray* upper = Find(image, "ShadowHeightUpper");
  vtkDataArray* lower = Find(image, "ShadowHeightLower");
  this->Soft = upper && lower;
  if (!this->Soft)
  {
    upper = lower = Find(image, "ShadowHeight");
  }
  const int* size = image->GetDimensions();
  if (!upper || !sun || sun->GetNumberOfValues() != 3 || size[0] < 2 || size[1] < 2)
  {
    return "the height field has no shadow heights (point array ShadowHeight, field array "
           "ShadowSun): give the output of vtkHeightFieldShadowHeight";
  }
  this->Azimuth = sun->GetComponent(0, 0) * RadiansPerDegree;
  this->Elevation = sun->GetComponent(0, 1) * RadiansPerDegree;
  this->Radius = this->Soft ? sun->GetComponent(0, 2) * RadiansPerDegree : 0.0;
  std::array<double, 6> bounds{};
  image->GetBounds(bounds.data());
  this->Middle[0] = 0.5 * (bounds[0] + bounds[1]);
  this->Middle[1] = 0.5 * (bounds[2] + bounds[3]);
  this->Posts = { { static_cast<float>(size[0]), static_cast<float>(size[1]) } };
  const vtkMTimeType time = std::max(upper->GetMTime(), lower->GetMTime());
  if (!this->Texture.IsStale(window, upper, time))
  {
    return {};
  }
  this->Gather(upper, lower);
  ++uploads;
  const bool sent =
    this->Texture.Upload(window, this->Values, size[0], size[1], 2, false, upper, time);
  this->Values = std::vector<float>();
  return sent ? std::string() : "OpenGL refuses the texture of the shadow heights";
}

// Infinite shadow heights mean that the sun has set. Missing shadow heights cast no shadow.
void ReceiverLight::Gather(vtkDataArray* upper, vtkDataArray* lower)
{
  double least = 0.0;
  double greatest = 0.0;
  bool any = false;
  const vtkIdType posts = upper->GetNumberOfTuples();
  for (vtkIdType post = 0; post < posts; ++post)
  {
    for (vtkDataArray* array : { upper, lower })
    {
      const double height = array->GetComponent(post, 0);
      if (std::isfinite(height))
      {
        least = any ? std::min(least, height) : height;
        greatest = any ? std::max(greatest, height) : height;
        any = true;
      }
    }
  }
  this->Middle[2] = 0.5 * (least + greatest);
  this->Slack = SlackPart * (greatest - least);
  this->Values.resize(2 * static_cast<std::size_t>(posts));
  for (vtkIdType post = 0; post < posts; ++post)
  {
    const double up = upper->GetComponent(post, 0);
    const double low = lower->GetComponent(post, 0);
    const bool known = std::isfinite(up) && std::isfinite(low);
    float* to = this->Values.data() + 2 * post;
    to[0] = known ? static_cast<float>(up - this->Middle[2]) : NoShadow;
    to[1] = known ? static_cast<float>(low - this->Middle[2]) : NoShadow;
  }
}

std::string ReceiverLight::AddText(
  const std::map<vtkShader::Type, vtkShader*>& shaders, Normals normals) const
{
  const bool points = normals == Normals::Points;
  for (const auto& [type, file] :
    { std::pair<vtkShader::Type, const char*>(vtkShader::Vertex, skyline_ReceiverVS),
      std::pair<vtkShader::Type, const char*>(vtkShader::Geometry, skyline_ReceiverGS) })
  {
    vtkShader* shader = shaders.at(type);
    AddAfter(shader, "//VTK::PositionVC::Dec",
      ShaderPart(file) + (points ? ShaderPart(file, "Points") : std::string()));
    AddAfter(shader, "//VTK::PositionVC::Impl",
      ShaderPart(file, "Impl") + (points ? ShaderPart(file, "PointsImpl") : std::string()));
  }
  return "#define SKYLINE_NORMAL " + std::to_string(static_cast<int>(normals)) + "\n" +
    (points ? ShaderPart(skyline_Receiver, "Points") : std::string()) +
    ShaderPart(skyline_Receiver);
}

void ReceiverLight::SetUniforms(vtkShaderProgram* program,
  vtkOpenGLVertexBufferObjectGroup* buffers, vtkMatrix4x4* placement,
  const std::array<Color, 9>& sky) const
{
  const char* names[3] = { "skylineWorldX", "skylineWorldY", "skylineWorldZ" };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    VertexRow row{};
    for (std::size_t k = 0; k < 4; ++k)
    {
      row[k] = placement->Element[axis][k];
    }
    row[3] -= this->Middle[axis];
    SetVertexRow(program, buffers, names[axis], row);
  }
  if (program->IsUniformUsed("skylineNormalMatrix"))
  {
    // Normals are transformed by the transposed inverse. OpenGL expects columns, so these are the
    // rows of the inverse itself.
    vtkNew<vtkMatrix3x3> turn;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        turn->SetElement(i, j, placement->GetElement(i, j));
      }
    }
    turn->Invert();
    program->SetUniformMatrix("skylineNormalMatrix", turn);
  }
  const ShadowHeightPenumbra penumbra(this->Elevation, this->Radius);
  const double level = std::cos(this->Elevation);
  const std::array<float, 3> direction{ { static_cast<float>(level * std::sin(this->Azimuth)),
    static_cast<float>(level * std::cos(this->Azimuth)),
    static_cast<float>(std::sin(this->Elevation)) } };
  program->SetUniform3f("skylineSunDirection", direction.data());
  const std::array<float, 4> disc{ { static_cast<float>(this->Elevation),
    static_cast<float>(this->Radius > 0.0 ? 1.0 / this->Radius : 0.0),
    static_cast<float>(penumbra.UpperSlope()), static_cast<float>(penumbra.LowerSlope()) } };
  program->SetUniform4f("skylineDisc", disc.data());
  const std::array<float, 4> fade{ { static_cast<float>(penumbra.Lit(0.0, 0.0, 1.0)),
    static_cast<float>(this->Soft ? 0.0 : this->PenumbraDepth), static_cast<float>(this->Slack),
    this->Soft && this->Radius > 0.0 ? 1.0f : 0.0f } };
  program->SetUniform4f("skylineFade", fade.data());
  program->SetUniform2f("skylinePosts", this->Posts.data());
  std::array<float, 3> sun{};
  std::transform(this->Sun.begin(), this->Sun.end(), sun.begin(),
    [](double value) { return static_cast<float>(value); });
  program->SetUniform3f("skylineSun", sun.data());
  std::array<float, 36> functions{};
  for (std::size_t j = 0; j < sky.size(); ++j)
  {
    std::transform(sky[j].begin(), sky[j].end(), functions.begin() + 4 * static_cast<int>(j),
      [](double value) { return static_cast<float>(value); });
  }
  program->SetUniform4fv("skylineSky", 9, functions.data());
}

} // namespace skyline
