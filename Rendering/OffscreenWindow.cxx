// SPDX-License-Identifier: BSD-3-Clause
#include "OffscreenWindow.h"

#include "HeadlessContext.h"
#include "vtkSkylineEGLWindow.h"

#include "vtkRenderWindow.h"

#include <cstdlib>

#include <dlfcn.h>

namespace
{

// VTK's X window ends the program if the X server does not answer. Therefore the server is tested
// first. VTK has already loaded Xlib, and nothing else in Skyline needs it.
bool DisplayAnswers()
{
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    return false;
  }
  void* xlib = dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
  if (!xlib)
  {
    return false;
  }
  const auto open = reinterpret_cast<void* (*)(const char*)>(dlsym(xlib, "XOpenDisplay"));
  const auto close = reinterpret_cast<int (*)(void*)>(dlsym(xlib, "XCloseDisplay"));
  void* display = open && close ? open(nullptr) : nullptr;
  if (display)
  {
    close(display);
  }
  dlclose(xlib);
  return display != nullptr;
}

} // namespace

namespace skyline
{

vtkSmartPointer<vtkRenderWindow> MakeOffscreenWindow(std::string& reason)
{
  HeadlessContext probe;
  if (probe.Create(-1))
  {
    return vtkSmartPointer<vtkSkylineEGLWindow>::New();
  }
  if (DisplayAnswers())
  {
    auto window = vtkSmartPointer<vtkRenderWindow>::New();
    window->SetOffScreenRendering(1);
    return window;
  }
  reason = probe.GetReason() + ", and no X server answers at the address in DISPLAY";
  return nullptr;
}

} // namespace skyline
