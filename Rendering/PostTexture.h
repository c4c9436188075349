// SPDX-License-Identifier: BSD-3-Clause
// An array of the posts as a texture.
#ifndef skyline_PostTexture_h
#define skyline_PostTexture_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Gives every missing post (not finite in one of its components) a value, so that a texture may be
/// interpolated beside it: the mean of its finite neighbours, or, farther inside a hole, the value
/// of a post to the west or south, then to the east or north. All missing: zeros. values: rows *
/// columns * components.
void FillMissing(
  std::vector<float>& values, std::size_t columns, std::size_t rows, std::size_t components);

/// Numbers per post on the graphics processor, interpolated linearly. Uploads only what changed.
class PostTexture
{
public:
  explicit PostTexture(const char* uniform);
  ~PostTexture();

  /// The name of its sampler.
  const std::string& GetUniform() const { return this->Uniform; }

  /// Whether the texture lacks what `source` held at `time` in this window's context.
  bool IsStale(vtkOpenGLRenderWindow* window, const void* source, vtkMTimeType time) const;

  /// Uploads `values` (1 to 4 components a post), 16-bit floats if `half`. False, where OpenGL does
  /// not take them.
  bool Upload(vtkOpenGLRenderWindow* window, const std::vector<float>& values, int columns,
    int rows, int components, bool half, const void* source, vtkMTimeType time);

  /// Takes a texture of somebody else's, who keeps it alive and releases it.
  void Borrow(vtkTextureObject* texture);

  void Activate();
  void Deactivate();
  int GetUnit();
  void Release(vtkWindow* window);

private:
  std::string Uniform;
  vtkSmartPointer<vtkTextureObject> Texture;
  const void* Source = nullptr;
  vtkMTimeType Time = 0;
  bool Borrowed = false;
};

} // namespace skyline

#endif
