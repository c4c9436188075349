// SPDX-License-Identifier: BSD-3-Clause
// A window of GLFW 3 in which VTK draws.
#ifndef skyline_GlfwWindow_h
#define skyline_GlfwWindow_h

#include "RunPass.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

struct GLFWwindow;
VTK_ABI_NAMESPACE_BEGIN
class vtkGenericOpenGLRenderWindow;
VTK_ABI_NAMESPACE_END

namespace skyline
{

class Viewer;

/// A window. GLFW is global in the process, so there can be only one at a time.
class GlfwWindow
{
public:
  /// `width` and `height` are in units of the desktop; they are reduced if the screen is smaller.
  /// Throws Failure without a display, or without OpenGL 3.2.
  GlfwWindow(int width, int height);
  ~GlfwWindow();
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  vtkGenericOpenGLRenderWindow* GetRenderWindow() const;
  GLFWwindow* GetHandle() const { return this->Handle; }

  /// Sends events to the viewer, which must live until Disconnect is called or Run ends.
  void Connect(Viewer& viewer);
  void Disconnect();

  /// Connects, and draws until the user quits. With --verbose, prints one line per picture with the
  /// times of its passes. Throws Failure when interrupted.
  void Run(Viewer& viewer, const CommonOptions& common);

private:
  void MakeRenderWindow();

  GLFWwindow* Handle = nullptr;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> Window;
};

} // namespace skyline

#endif
