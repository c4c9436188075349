// SPDX-License-Identifier: BSD-3-Clause
// Numbers in textures, and fragment passes over them: what the filters on the graphics processor
// are made of. OpenGL 3.2.
#ifndef skyline_TwinDevice_h
#define skyline_TwinDevice_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;

namespace skyline
{

using TwinTexture = vtkSmartPointer<vtkTextureObject>;

/// A rectangle of texels.
struct TwinArea
{
  int X = 0, Y = 0, Width = 0, Height = 0;
};

/// What becomes of numbers that are there already.
enum class TwinBlend
{
  Replace,
  Add,
  Greatest
};

/// The context of a render window: a given one, or one without a window system of its own.
class TwinDevice
{
public:
  TwinDevice();
  ~TwinDevice();
  TwinDevice(const TwinDevice&) = delete;
  TwinDevice& operator=(const TwinDevice&) = delete;

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
  TwinTexture Image(int width, int height, int components, const float* values = nullptr);
  /// Layers of images: a texture of three dimensions.
  TwinTexture Stack(int width, int height, int layers, int components);

  /// Four floats a texel from an image of four components.
  void Read(vtkTextureObject* image, const TwinArea& area, float* values);

  void Finish(); ///< waits until all is drawn
  void Close();  ///< gives everything back

private:
  friend class TwinPass;
  vtkSmartPointer<vtkRenderWindow> Given, Own;
  vtkSmartPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Frame;
  TwinTexture Sentinel; // gone with the context
};

/// Keeps what else draws with the context from noticing: framebuffers, viewport, blending.
class TwinState
{
public:
  explicit TwinState(const TwinDevice& device);
  ~TwinState();
  TwinState(const TwinState&) = delete;
  TwinState& operator=(const TwinState&) = delete;

private:
  struct Saved;
  std::unique_ptr<Saved> Before;
};

/// A fragment shader that fills areas of textures. Its text ends where VTK's markers for the version
/// and the outputs (gl_FragData) have been replaced.
class TwinPass
{
public:
  TwinPass(TwinDevice& device, const std::string& fragment);
  ~TwinPass();
  TwinPass(const TwinPass&) = delete;
  TwinPass& operator=(const TwinPass&) = delete;

  /// False if the shader could not be built. To be called before the settings below.
  bool Use();
  void Set(const char* name, vtkTextureObject* texture);
  void Set(const char* name, int value);
  void Set(const char* name, int x, int y);
  void Set(const char* name, float value);
  void Set(const char* name, const std::vector<float>& vectors); ///< of four

  /// Fills the area of up to eight images, or of one layer of a stack.
  void Draw(const std::vector<vtkTextureObject*>& targets, const TwinArea& area,
    TwinBlend blend = TwinBlend::Replace);
  void DrawLayer(vtkTextureObject* stack, int layer, const TwinArea& area);

private:
  void DrawBound(unsigned int targets, const TwinArea& area, TwinBlend blend);

  TwinDevice& Device;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::vector<TwinTexture> Inputs;
};

} // namespace skyline

#endif
