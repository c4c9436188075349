// SPDX-License-Identifier: BSD-3-Clause
// A texture that holds an array of the posts.
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

/// Gives each missing post (not finite in one of its components) a value, so that the texture can
/// be interpolated beside it: the mean of its finite neighbours, or, deeper inside a hole, the
/// value of a post to the west or south, then to the east or north. If all posts are missing, the
/// values are 0. values: rows * columns * components.
void FillMissing(
  std::vector<float>& values, std::size_t columns, std::size_t rows, std::size_t components);

/// Numbers per post on the graphics processor, interpolated linearly. Only changes are uploaded.
class PostTexture
{
public:
  explicit PostTexture(const char* uniform);
  ~PostTexture();

  /// The name of the sampler in the shader.
  const std::string& GetUniform() const { return this->Uniform; }

  /// Whether the texture does not hold what `source` held at `time`, or belongs to another context.
  bool IsStale(vtkOpenGLRenderWindow* window, const void* source, vtkMTimeType time) const;

  /// Uploads `values` (1 to 4 components per post), as 16-bit floats if `half`. Returns false if
  /// OpenGL does not accept them.
  bool Upload(vtkOpenGLRenderWindow* window, const std::vector<float>& values, int columns,
    int rows, int components, bool half, const void* source, vtkMTimeType time);

  /// Uses the texture of another owner, which keeps it alive and releases it.
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
