// SPDX-License-Identifier: BSD-3-Clause
// Mode RECEIVER of vtkSkylineSoftShadowShader: shadow heights as a texture, and the sun behind them.
#ifndef skyline_ReceiverLight_h
#define skyline_ReceiverLight_h

#include "PostTexture.h"
#include "VertexRow.h"

#include "vtkShader.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <array>
#include <map>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
class vtkMatrix4x4;
class vtkOpenGLRenderWindow;
VTK_ABI_NAMESPACE_END

namespace skyline
{

class ReceiverLight
{
public:
  /// Which normals a mesh has; vtkSkylineSoftShadowShader's NormalType.
  enum class Normals
  {
    Faces,
    Points,
    None
  };

  using Color = std::array<double, 3>;

  PostTexture Texture{ "skylineShadow" };
  Color Sun{ { 1.0, 1.0, 1.0 } }; ///< irradiance of a plane that faces the sun
  double PenumbraDepth = 0.0;     ///< metres; counts without shadow heights of both limbs

  /// Uploads the image's shadow heights if they changed, and adds to `uploads`. Returns nothing, or in
  /// one line what the image lacks.
  std::string Prepare(vtkOpenGLRenderWindow* window, vtkImageData* image, int& uploads);

  /// Text for the fragment shader; changes the two others.
  std::string AddText(const std::map<vtkShader::Type, vtkShader*>& shaders, Normals normals) const;

  /// placement: from the mesh's coordinates to those of the image. sky: irradiance of each function of
  /// the normal in Receiver.glsl.
  void SetUniforms(vtkShaderProgram* program, vtkOpenGLVertexBufferObjectGroup* buffers,
    vtkMatrix4x4* placement, const std::array<Color, 9>& sky) const;

private:
  void Gather(vtkDataArray* upper, vtkDataArray* lower);

  std::array<float, 2> Posts{};
  std::array<double, 3> Middle{}; // of the image; heights: the base
  double Slack = 0.0;
  double Azimuth = 0.0, Elevation = 0.0, Radius = 0.0; // radians
  bool Soft = false;
  std::vector<float> Values;
};

} // namespace skyline

#endif
