// SPDX-License-Identifier: BSD-3-Clause
// Numbers in textures, and fragment passes over them: what the filters on the graphics processor
// are made of. OpenGL 3.2.
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

/// What becomes of numbers that are there already.
enum class GpuBlend
{
  Replace,
  Add,
  Greatest
};

/// The context of a render window: a given one, or one without a window system of its own.
class GpuDevice
{
public:
  GpuDevice();
  ~GpuDevice();
  GpuDevice(const GpuDevice&) = delete;
  GpuDevice& operator=(const GpuDevice&) = delete;

  /// The window to compute in; null (default): MakeOffscreenWindow's.
  void SetWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetWindow() const;

  /// Makes the context current. False, and the reason in one line, where there is none. `renewed`: what
  /// was made before is gone, as with a context that was lost.
  bool Open(std::string& reason, bool& renewed);

  vtkOpenGLRenderWindow* Context() const;
  std::string Name() const; ///< of the graphics processor, as OpenGL says it
  int ImageLimit() const;   ///< greatest side of an image
  int StackLimit() const;   ///< greatest side, and number of layers, of a stack

  /// Floats; 1, 2 or 4 a texel; null without memory. values: row by row, or null: not set.
  GpuTexture Image(int width, int height, int components, const float* values = nullptr);
  /// Layers of images: a texture of three dimensions.
  GpuTexture Stack(int width, int height, int layers, int components);

  /// Four floats a texel from an image of four components.
  void Read(vtkTextureObject* image, const GpuArea& area, float* values);

  void Finish(); ///< waits until all is drawn
  void Close();  ///< gives everything back

private:
  friend class GpuPass;
  vtkSmartPointer<vtkRenderWindow> Given, Own;
  vtkSmartPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Frame;
  GpuTexture Sentinel; // gone with the context
};

/// Keeps what else draws with the context from noticing: framebuffers, viewport, blending.
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

/// A fragment shader that fills areas of textures. Its text ends where VTK's markers for the version
/// and the outputs (gl_FragData) have been replaced.
class GpuPass
{
public:
  GpuPass(GpuDevice& device, const std::string& fragment);
  ~GpuPass();
  GpuPass(const GpuPass&) = delete;
  GpuPass& operator=(const GpuPass&) = delete;

  /// False if the shader could not be built. To be called before the settings below.
  bool Use();
  void Set(const char* name, vtkTextureObject* texture);
  void Set(const char* name, int value);
  void Set(const char* name, int x, int y);
  void Set(const char* name, float value);
  void Set(const char* name, const std::vector<float>& vectors); ///< of four

  /// Fills the area of up to eight images, or of one layer of a stack.
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
