// SPDX-License-Identifier: BSD-3-Clause
#include "GlfwWindow.h"

#include "Failure.h"
#include "Interrupt.h"
#include "Viewer.h"
#include "ViewerInput.h"

#include "vtkCallbackCommand.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkNew.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <string>
#include <vector>

namespace
{

/// An interrupt is noticed within this many seconds, with or without events.
constexpr double LongestWait = 0.5;

constexpr int LeastWidth = 160;
constexpr int LeastHeight = 120;

std::string& LastReason()
{
  static std::string reason;
  return reason;
}

void KeepReason(int, const char* text)
{
  LastReason() = text ? text : "";
}

skyline::Viewer* ViewerOf(GLFWwindow* window)
{
  return static_cast<skyline::Viewer*>(glfwGetWindowUserPointer(window));
}

skyline::Modifiers ModifiersOf(int bits)
{
  skyline::Modifiers with;
  with.Shift = (bits & GLFW_MOD_SHIFT) != 0;
  with.Control = (bits & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0;
  return with;
}

// Pixels of the framebuffer per unit of the window.
double PixelsPerUnit(GLFWwindow* window)
{
  int units = 0;
  int pixels = 0;
  int height = 0;
  glfwGetWindowSize(window, &units, &height);
  glfwGetFramebufferSize(window, &pixels, &height);
  return units > 0 && pixels > 0 ? static_cast<double>(pixels) / units : 1.0;
}

void TellSize(GLFWwindow* window)
{
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  float scale = 1.0f;
  float vertical = 1.0f;
  glfwGetWindowContentScale(window, &scale, &vertical);
  ViewerOf(window)->Resize(width, height, std::max(0.5f, scale));
}

int KeyOf(int key, int scancode)
{
  switch (key)
  {
    case GLFW_KEY_LEFT:
      return skyline::KeyLeft;
    case GLFW_KEY_RIGHT:
      return skyline::KeyRight;
    case GLFW_KEY_UP:
      return skyline::KeyUp;
    case GLFW_KEY_DOWN:
      return skyline::KeyDown;
    case GLFW_KEY_PAGE_UP:
      return skyline::KeyPageUp;
    case GLFW_KEY_PAGE_DOWN:
      return skyline::KeyPageDown;
    case GLFW_KEY_HOME:
      return skyline::KeyHome;
    case GLFW_KEY_ESCAPE:
      return skyline::KeyEscape;
    case GLFW_KEY_DELETE:
    case GLFW_KEY_BACKSPACE:
      return skyline::KeyDelete;
    case GLFW_KEY_SPACE:
      return skyline::KeySpace;
    case GLFW_KEY_KP_ADD:
      return '=';
    case GLFW_KEY_KP_SUBTRACT:
      return '-';
    default:
      break;
  }
  // Use the sign that is printed on the key in the user's layout, if it is a plain one.
  const char* name = glfwGetKeyName(key, scancode);
  if (name && name[0] > ' ' && name[1] == '\0')
  {
    return std::toupper(static_cast<unsigned char>(name[0]));
  }
  return key > ' ' && key < 127 ? key : static_cast<int>(skyline::KeyUnknown);
}

void OnKey(GLFWwindow* window, int key, int scancode, int action, int bits)
{
  if (action != GLFW_RELEASE)
  {
    ViewerOf(window)->KeyPress(KeyOf(key, scancode), ModifiersOf(bits));
  }
}

void OnMove(GLFWwindow* window, double x, double y)
{
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  const double pixels = PixelsPerUnit(window);
  ViewerOf(window)->MouseMove(x * pixels, height - 1.0 - y * pixels);
}

void OnButton(GLFWwindow* window, int button, int action, int bits)
{
  if (button > GLFW_MOUSE_BUTTON_MIDDLE)
  {
    return;
  }
  // Use the position of the last move event: the cursor may be further on if a picture took long.
  ViewerOf(window)->MousePress(button == GLFW_MOUSE_BUTTON_LEFT ? skyline::MouseButton::Left
      : button == GLFW_MOUSE_BUTTON_RIGHT                       ? skyline::MouseButton::Right
                                                                : skyline::MouseButton::Middle,
    action == GLFW_PRESS, ModifiersOf(bits));
}

void OnDrop(GLFWwindow* window, int count, const char** files)
{
  ViewerOf(window)->Drop(std::vector<std::string>(files, files + count));
  glfwSetWindowTitle(window, ViewerOf(window)->GetTitle().c_str());
}

// Calls a function at a VTK event.
template <typename Function>
void Observe(vtkObject* object, unsigned long event, GLFWwindow* handle, Function function)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(handle);
  command->SetCallback(function);
  object->AddObserver(event, command);
}

void PrintTimes(const skyline::Viewer& viewer, unsigned long number)
{
  std::fprintf(stderr, "picture %lu:", number);
  double sum = 0.0;
  for (const auto& [name, seconds] : viewer.GetTimes())
  {
    std::fprintf(stderr, " %s %.1f,", name.c_str(), 1000.0 * seconds);
    sum += seconds;
  }
  std::fprintf(stderr, " all %.1f ms\n", 1000.0 * sum);
}

} // namespace

namespace skyline
{

GlfwWindow::GlfwWindow(int width, int height)
{
  glfwSetErrorCallback(KeepReason);
#ifdef GLFW_PLATFORM_X11
  glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11); // VTK of Debian uses OpenGL through GLX
#endif
  if (!glfwInit())
  {
    throw Failure(
      "no window can be opened: " + LastReason() + "; shade --view perspective needs no display");
  }
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SAMPLES, 0);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor())
  {
    int x = 0;
    int y = 0;
    int screenWidth = 0;
    int screenHeight = 0;
    glfwGetMonitorWorkarea(monitor, &x, &y, &screenWidth, &screenHeight);
    width = screenWidth > 0 ? std::min(width, screenWidth) : width;
    height = screenHeight > 0 ? std::min(height, screenHeight) : height;
  }
  this->Handle = glfwCreateWindow(
    std::max(width, LeastWidth), std::max(height, LeastHeight), "skyline", nullptr, nullptr);
  if (!this->Handle)
  {
    const std::string reason = LastReason();
    glfwTerminate();
    throw Failure(
      "no window with OpenGL 3.2 can be opened: " + reason + "; shade --view map needs no OpenGL");
  }
  glfwSetWindowSizeLimits(this->Handle, LeastWidth, LeastHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(this->Handle);
  glfwSwapInterval(1);
  // VTK restores the initial state of the context after each picture and relies on this depth
  // function, which is not the default of OpenGL. Without it, the first of two flat objects at the
  // same depth would be drawn.
  constexpr unsigned int lessOrEqual = 0x0203;
  reinterpret_cast<void (*)(unsigned int)>(glfwGetProcAddress("glDepthFunc"))(lessOrEqual);
  this->MakeRenderWindow();
}

GlfwWindow::~GlfwWindow()
{
  this->Disconnect();
  this->Window->Finalize();
  this->Window->RemoveAllObservers();
  this->Window = nullptr;
  glfwDestroyWindow(this->Handle);
  glfwTerminate();
}

vtkGenericOpenGLRenderWindow* GlfwWindow::GetRenderWindow() const
{
  return this->Window;
}

void GlfwWindow::MakeRenderWindow()
{
  this->Window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
  this->Window->SetOwnContext(0);
  this->Window->SetMapped(1);
  this->Window->SetReadyForRendering(true);
  this->Window->SetMultiSamples(0);
  this->Window->SetFrameBlitModeToBlitToHardware();
  Observe(this->Window, vtkCommand::WindowMakeCurrentEvent, this->Handle,
    [](vtkObject*, unsigned long, void* handle, void*)
    { glfwMakeContextCurrent(static_cast<GLFWwindow*>(handle)); });
  Observe(this->Window, vtkCommand::WindowIsCurrentEvent, this->Handle,
    [](vtkObject*, unsigned long, void* handle, void* answer)
    { *static_cast<bool*>(answer) = glfwGetCurrentContext() == handle; });
  Observe(this->Window, vtkCommand::WindowSupportsOpenGLEvent, this->Handle,
    [](vtkObject*, unsigned long, void*, void* answer) { *static_cast<int*>(answer) = 1; });
  Observe(this->Window, vtkCommand::WindowIsDirectEvent, this->Handle,
    [](vtkObject*, unsigned long, void*, void* answer) { *static_cast<int*>(answer) = 1; });
  Observe(this->Window, vtkCommand::WindowFrameEvent, this->Handle,
    [](vtkObject*, unsigned long, void* handle, void*)
    { glfwSwapBuffers(static_cast<GLFWwindow*>(handle)); });
}

void GlfwWindow::Connect(Viewer& viewer)
{
  glfwSetWindowUserPointer(this->Handle, &viewer);
  viewer.Poll = [] { glfwPollEvents(); };
  glfwSetKeyCallback(this->Handle, OnKey);
  glfwSetCursorPosCallback(this->Handle, OnMove);
  glfwSetMouseButtonCallback(this->Handle, OnButton);
  glfwSetScrollCallback(
    this->Handle, [](GLFWwindow* window, double, double steps) { ViewerOf(window)->Wheel(steps); });
  glfwSetDropCallback(this->Handle, OnDrop);
  glfwSetFramebufferSizeCallback(
    this->Handle, [](GLFWwindow* window, int, int) { TellSize(window); });
  glfwSetWindowContentScaleCallback(
    this->Handle, [](GLFWwindow* window, float, float) { TellSize(window); });
  glfwSetWindowIconifyCallback(this->Handle,
    [](GLFWwindow* window, int away) { ViewerOf(window)->Minimise(away == GLFW_TRUE); });
  glfwSetWindowRefreshCallback(
    this->Handle, [](GLFWwindow* window) { ViewerOf(window)->Expose(); });
  glfwSetWindowTitle(this->Handle, viewer.GetTitle().c_str());
  TellSize(this->Handle);
  double x = 0.0;
  double y = 0.0;
  glfwGetCursorPos(this->Handle, &x, &y);
  OnMove(this->Handle, x, y); // a press may come before any move
}

void GlfwWindow::Disconnect()
{
  glfwSetKeyCallback(this->Handle, nullptr);
  glfwSetCursorPosCallback(this->Handle, nullptr);
  glfwSetMouseButtonCallback(this->Handle, nullptr);
  glfwSetScrollCallback(this->Handle, nullptr);
  glfwSetDropCallback(this->Handle, nullptr);
  glfwSetFramebufferSizeCallback(this->Handle, nullptr);
  glfwSetWindowContentScaleCallback(this->Handle, nullptr);
  glfwSetWindowIconifyCallback(this->Handle, nullptr);
  glfwSetWindowRefreshCallback(this->Handle, nullptr);
  glfwSetWindowUserPointer(this->Handle, nullptr);
}

void GlfwWindow::Run(Viewer& viewer, const CommonOptions& common)
{
  this->Connect(viewer);
  unsigned long pictures = 0;
  while (!glfwWindowShouldClose(this->Handle) && !viewer.WantsToLeave())
  {
    StopIfInterrupted();
    if (viewer.Draw(glfwGetTime()) && common.Verbose)
    {
      PrintTimes(viewer, ++pictures);
    }
    const double patience = viewer.GetPatience(glfwGetTime());
    if (patience == 0.0)
    {
      glfwPollEvents();
    }
    else
    {
      glfwWaitEventsTimeout(patience < 0.0 ? LongestWait : std::min(patience, LongestWait));
    }
  }
  this->Disconnect();
}

} // namespace skyline
