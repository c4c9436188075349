// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSkylineEGLWindow
 * @brief a render window without a window system
 *
 * Owns an OpenGL 3.2 core context that EGL makes without a surface. It needs no X server, on a
 * graphics processor as well as with Mesa's llvmpipe. The window draws into VTK's own framebuffer.
 * Read the picture with vtkWindowToImageFilter or with GetRGBACharPixelData(..., front = 0).
 *
 * If EGL provides no context, Render draws nothing and reports the reason once, in one line.
 * IsSupported checks this without an error. VTK 9.4 introduced a similar window,
 * vtkEGLRenderWindow; this one works with VTK 9.1 and later.
 */
#ifndef vtkSkylineEGLWindow_h
#define vtkSkylineEGLWindow_h

#include "SkylineRenderingModule.h" // For export macro
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkVersionMacros.h"       // For OpenGLInitContext

#include <memory> // For Context
#include <string> // For GetReason

namespace skyline
{
class HeadlessContext;
}

VTK_ABI_NAMESPACE_BEGIN
class SKYLINERENDERING_EXPORT vtkSkylineEGLWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkSkylineEGLWindow* New();
  vtkTypeMacro(vtkSkylineEGLWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Returns whether such a window can be made on this machine, by trying to make a context. Returns
   * false if Skyline was built without EGL.
   */
  static bool IsSupported();

  ///@{
  /**
   * Number of the EGL device to draw on. Graphics processors come before devices that draw on the
   * host. Default: -1, the first device that works. Must be set before the first Render.
   */
  vtkSetMacro(Device, int);
  vtkGetMacro(Device, int);
  ///@}

  /**
   * Returns in one line why there is no context, or an empty string if nothing failed.
   */
  std::string GetReason();

  ///@{
  /**
   * See vtkRenderWindow.
   */
  void Initialize() override;
  void Finalize() override;
  void Render() override;
  void MakeCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override;
  vtkTypeBool IsDirect() override;
  int GetColorBufferSizes(int* rgba) override;
  void ReleaseCurrent() override;
  ///@}

protected:
  vtkSkylineEGLWindow();
  ~vtkSkylineEGLWindow() override;

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
  void OpenGLInitContext() override;
#endif

private:
  bool Ready();

  std::unique_ptr<skyline::HeadlessContext> Context;
  int Device = -1;
  bool Failed = false;

  vtkSkylineEGLWindow(const vtkSkylineEGLWindow&) = delete;
  void operator=(const vtkSkylineEGLWindow&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
