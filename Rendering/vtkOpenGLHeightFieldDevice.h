// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenGLHeightFieldDevice
 * @brief   the graphics processor on which filters for height fields compute
 *
 * Holds the OpenGL context that the filters vtkOpenGLHeightField... share. This is either the
 * context of a given render window, so that a mapper can draw the results directly, or a context
 * without a window system: that of a vtkSkylineEGLWindow or, where EGL provides none, that of an
 * off-screen window of the X server. The filters need OpenGL 3.2.
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
  /// The window whose context is used. Default: null, which makes an off-screen window.
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  ///@}

  ///@{
  /// Greatest side of a texture, in texels, 0 to 65536. Default: 0, the limit of OpenGL. Larger
  /// height fields are computed in tiles.
  vtkSetClampMacro(TextureLimit, int, 0, 65536);
  vtkGetMacro(TextureLimit, int);
  ///@}

  ///@{
  /// Memory in MiB that a height pyramid at full size may take on the graphics processor, 0 to
  /// 1048576. Default: 1024. A larger pyramid is computed in tiles, which takes less memory and
  /// more time.
  vtkSetClampMacro(MemoryLimit, int, 0, 1048576);
  vtkGetMacro(MemoryLimit, int);
  ///@}

  /// Returns whether there is an OpenGL context. If there is none yet, tries to make one. Makes the
  /// context current. A failure raises no error; GetReason returns its cause.
  bool IsAvailable();

  /// Returns in one line why there is no context, or an empty string if there is one.
  std::string GetReason();

  /// Returns the name of the graphics processor as OpenGL reports it, or an empty string if there
  /// is no context.
  std::string GetName();

  /// Number of contexts made so far. After it changes, all objects made with an earlier context are
  /// lost.
  vtkGetMacro(Generation, int);

#ifndef __VTK_WRAP__
  skyline::GpuDevice& Gpu();         ///< for the filters vtkOpenGL...
  skyline::GpuLimits Limits() const; ///< TextureLimit and MemoryLimit
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
