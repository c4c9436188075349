// SPDX-License-Identifier: BSD-3-Clause
// Numbers in textures, and fragment shaders that compute with them: the basis of the filters on the
// graphics processor. Needs OpenGL 3.2.
#ifndef skyline_GpuDevice_h
#define skyline_GpuDevice_h

#include "vtkNew.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
VTK_ABI_NAMESPACE_END

namespace skyline
{

using GpuTexture = vtkSmartPointer<vtkTextureObject>;

/// A rectangle of texels.
struct GpuArea
{
  int X = 0, Y = 0, Width = 0, Height = 0;
};

/// How a pass combines its result with the numbers in the target.
enum class GpuBlend
{
  Replace,
  Add,
  Greatest
};

/// The OpenGL context of a render window, either a given one or an own one without a window system.
class GpuDevice
{
public:
  GpuDevice();
  ~GpuDevice();
  GpuDevice(const GpuDevice&) = delete;
  GpuDevice& operator=(const GpuDevice&) = delete;

  /// The window whose context computes. Null (the default) stands for the window that
  /// MakeOffscreenWindow returns.
  void SetWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetWindow() const;

  /// Makes the context current. Returns false, and the reason in one line, if there is no context.
  /// `renewed` tells that objects made earlier are lost, because the context is a new one.
  bool Open(std::string& reason, bool& renewed);

  vtkOpenGLRenderWindow* Context() const;
  std::string Name() const; ///< of the graphics processor, as OpenGL reports it
  int ImageLimit() const;   ///< greatest side of an image, texels
  int StackLimit() const;   ///< greatest side and greatest number of layers of a stack

  /// A texture of floats with 1, 2 or 4 components per texel, or null if memory is short. values:
  /// row by row; null leaves the texture uninitialized.
  GpuTexture Image(int width, int height, int components, const float* values = nullptr);
  /// A three-dimensional texture: a stack of images.
  GpuTexture Stack(int width, int height, int layers, int components);

  /// Reads four floats per texel from an image with four components.
  void Read(vtkTextureObject* image, const GpuArea& area, float* values);

  void Finish(); ///< waits until all drawing is done
  void Close();  ///< releases everything

private:
  friend class GpuPass;
  vtkSmartPointer<vtkRenderWindow> Given, Own;
  vtkSmartPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Frame;
  GpuTexture ContextGuard; // destroyed with the context
};

/// Saves and restores the state of OpenGL that the passes change (framebuffers, viewport,
/// blending), so that other users of the context are not affected.
class GpuState
{
public:
  explicit GpuState(const GpuDevice& device);
  ~GpuState();
  GpuState(const GpuState&) = delete;
  GpuState& operator=(const GpuState&) = delete;

private:
  struct Saved;
  std::unique_ptr<Saved> Before;
};

/// A fragment shader that fills areas of textures. VTK's markers for the version and for the
/// outputs (gl_FragData) in its text are replaced by VTK.
class GpuPass
{
public:
  GpuPass(GpuDevice& device, const std::string& fragment);
  ~GpuPass();
  GpuPass(const GpuPass&) = delete;
  GpuPass& operator=(const GpuPass&) = delete;

  /// Makes the shader current; false if it could not be compiled. To be called before the methods
  /// below.
  bool Use();
  void Set(const char* name, vtkTextureObject* texture);
  void Set(const char* name, int value);
  void Set(const char* name, int x, int y);
  void Set(const char* name, float value);
  void Set(const char* name, const std::vector<float>& vectors); ///< vectors of four numbers

  /// Fills an area of up to eight images, or of one layer of a stack.
  void Draw(const std::vector<vtkTextureObject*>& targets, const GpuArea& area,
    GpuBlend blend = GpuBlend::Replace);
  void DrawLayer(vtkTextureObject* stack, int layer, const GpuArea& area);

private:
  void DrawBound(unsigned int targets, const GpuArea& area, GpuBlend blend);

  GpuDevice& Device;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::vector<GpuTexture> Inputs;
};

} // namespace skyline

#endif
