// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLHeightFieldDevice
 * @brief   the graphics processor that filters on height fields compute on
 *
 * Holds the OpenGL context of the filters vtkOpenGLHeightField... that share it: that of a render
 * window, so that a mapper may draw what they leave there, or one without a window system
 * (vtkSkylineEGLWindow, or the X server's where EGL gives none). OpenGL 3.2 is enough.
 */
#ifndef vtkOpenGLHeightFieldDevice_h
#define vtkOpenGLHeightFieldDevice_h

#include "SkylineRenderingModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <memory> // For Internals
#include <string> // For GetReason

namespace skyline
{
class GpuDevice;
struct GpuLimits;
} // namespace skyline

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;

class SKYLINERENDERING_EXPORT vtkOpenGLHeightFieldDevice : public vtkObject
{
public:
  static vtkOpenGLHeightFieldDevice* New();
  vtkTypeMacro(vtkOpenGLHeightFieldDevice, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The window whose context computes; default null: one of its own that nobody sees.
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  ///@}

  ///@{
  /// Greatest side of a texture; default 0: OpenGL's own limit. Larger height fields go tile by tile.
  vtkSetClampMacro(TextureLimit, int, 0, 65536);
  vtkGetMacro(TextureLimit, int);
  ///@}

  ///@{
  /// Memory that a pyramid may take there at full size, MiB; default 1024. A larger one goes tile by tile,
  /// which takes less and longer.
  vtkSetClampMacro(MemoryLimit, int, 0, 1048576);
  vtkGetMacro(MemoryLimit, int);
  ///@}

  /// Whether there is a context; tries to make one, and makes it current. No error: GetReason tells.
  bool IsAvailable();

  /// Why there is none, in one line; empty while there is.
  std::string GetReason();

  /// What OpenGL calls the processor; empty without a context.
  std::string GetName();

  /// Counts the contexts so far: what was made with another one is gone.
  vtkGetMacro(Generation, int);

#ifndef __VTK_WRAP__
  skyline::GpuDevice& Gpu(); ///< for the filters
  skyline::GpuLimits Limits() const;
#endif

protected:
  vtkOpenGLHeightFieldDevice();
  ~vtkOpenGLHeightFieldDevice() override;

private:
  vtkOpenGLHeightFieldDevice(const vtkOpenGLHeightFieldDevice&) = delete;
  void operator=(const vtkOpenGLHeightFieldDevice&) = delete;

  int TextureLimit = 0;
  int MemoryLimit = 1024;
  int Generation = 0;
  std::string Reason;
  std::unique_ptr<skyline::GpuDevice> Device;
};
VTK_ABI_NAMESPACE_END

#endif
