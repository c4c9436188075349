// SPDX-License-Identifier: BSD-3-Clause
// The textures that a soft shadow shader reads: arrays of a height field, at the resolution of its
// posts.
#ifndef skyline_SoftShadowTextures_h
#define skyline_SoftShadowTextures_h

#include "PostTexture.h"
#include "ReceiverLight.h"
#include "VertexRow.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkOpenGLRenderWindow;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Functions that return a string return an empty string on success, otherwise the reason, in one
/// line, why the terrain cannot be lit. The context of `window` must be current.
struct SoftShadowTextures
{
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkTextureObject> IrradianceTexture; ///< read instead of an array; may be null

  PostTexture Irradiance{ "skylineIrradiance" };
  std::array<PostTexture, 4> Harmonics{ { PostTexture("skylineHarmonics0"),
    PostTexture("skylineHarmonics1"), PostTexture("skylineHarmonics2"),
    PostTexture("skylineHarmonics3") } };
  PostTexture Gradient{ "skylineGradient" };
  PostTexture LampLight{ "skylineLampTexture" };
  ReceiverLight Receiver;
  vtkNew<vtkMatrix4x4> Placement;  ///< of the actor, in the mode RECEIVER
  std::vector<PostTexture*> InUse; ///< what was sent last
  int Uploads = 0;                 ///< of all textures so far

  /// Rows of the matrix from positions of the image to texture coordinates; see Place.
  VertexRow Across{};
  VertexRow Up{};

  /// Checks that the image fits into a texture.
  std::string CheckImage(vtkOpenGLRenderWindow* window) const;

  /// Computes Across and Up. Post i lies at the centre of texel i.
  void Place();

  /// The same row for the mesh of an actor with the matrix Placement.
  VertexRow Placed(const VertexRow& row) const;

  /// The point array `name` if it has a value for each post and `least` to `most` components, else
  /// null.
  vtkDataArray* Find(const std::string& name, int least, int most) const;

  /// The reason why the array `name` cannot be used. components: how many it needs, as text.
  std::string Missing(const std::string& name, const char* components) const;

  /// Uploads `count` components from `first` on, unless the texture already shows the array. half:
  /// as 16-bit floats.
  std::string Send(PostTexture& texture, vtkOpenGLRenderWindow* window, vtkDataArray* array,
    int first, int count, bool half);

  /// Sends IrradianceTexture or, without one, the array `name` of three components.
  std::string SendIrradiance(const std::string& name, vtkOpenGLRenderWindow* window);

  /// Sends the array `name` of 16 coefficients as four textures.
  std::string SendHarmonics(const std::string& name, vtkOpenGLRenderWindow* window);

  /// Sends the gradients of the array `name`, or of the scalars where there is no such array.
  std::string SendGradients(const std::string& name, vtkOpenGLRenderWindow* window);

  /// Sends the shadow heights of the mode RECEIVER.
  std::string SendReceiver(vtkOpenGLRenderWindow* window);
};

} // namespace skyline

#endif
