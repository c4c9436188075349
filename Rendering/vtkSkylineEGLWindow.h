// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSkylineEGLWindow
 * @brief a render window without a window system
 *
 * Owns an OpenGL 3.2 core context that EGL makes without a surface: no X server is needed, neither
 * on a graphics processor nor with Mesa's llvmpipe. It draws into VTK's own framebuffer; read the
 * picture by vtkWindowToImageFilter or GetRGBACharPixelData(..., front = 0).
 *
 * Where EGL gives no context, Render draws nothing and reports why, once, in one line; IsSupported
 * asks without an error. VTK 9.4 has such a window of its own, vtkEGLRenderWindow; this one works
 * from 9.1.
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
   * Whether such a window can be had here: tries to make a context. False where Skyline was built
   * without EGL.
   */
  static bool IsSupported();

  ///@{
  /**
   * EGL's device to draw on, graphics processors before the host. Default -1: the first that works.
   * Counts before the first Render.
   */
  vtkSetMacro(Device, int);
  vtkGetMacro(Device, int);
  ///@}

  /**
   * Why there is no context, in one line; empty while all is well.
   */
  std::string GetReason();

  ///@{
  /**
   * As for every render window.
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
