// SPDX-License-Identifier: BSD-3-Clause
// A window of GLFW 3 that VTK draws in.
#ifndef skyline_GlfwWindow_h
#define skyline_GlfwWindow_h

#include "Passes.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

struct GLFWwindow;
VTK_ABI_NAMESPACE_BEGIN
class vtkGenericOpenGLRenderWindow;
VTK_ABI_NAMESPACE_END

namespace skyline
{

class Viewer;

/// GLFW is the process's: one window at a time.
class GlfwWindow
{
public:
  /// `width`, `height`: of the window in the desktop's units, made smaller where the screen is. Throws
  /// Failure where there is no display, or no OpenGL 3.2 on it.
  GlfwWindow(int width, int height);
  ~GlfwWindow();
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  vtkGenericOpenGLRenderWindow* GetRenderWindow() const;
  GLFWwindow* GetHandle() const { return this->Handle; }

  /// From now on events go to the viewer, which must live until Disconnect or Run ends.
  void Connect(Viewer& viewer);
  void Disconnect();

  /// Connects, and draws until the user leaves. Verbose: a line a picture with the times of its
  /// passes. Throws Failure when interrupted.
  void Run(Viewer& viewer, const Talk& talk);

private:
  void MakeRenderWindow();

  GLFWwindow* Handle = nullptr;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> Window;
};

} // namespace skyline

#endif
