// SPDX-License-Identifier: BSD-3-Clause
#include "HeadlessContext.h"

#ifdef SKYLINE_HAS_EGL

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <vector>

namespace
{

// Enumerants of extensions that older EGL headers do not define.
constexpr EGLenum PlatformDevice = 0x313F;      // EGL_PLATFORM_DEVICE_EXT
constexpr EGLenum PlatformSurfaceless = 0x31DD; // EGL_PLATFORM_SURFACELESS_MESA

using Devices = EGLBoolean (*)(EGLint, void**, EGLint*);
using DeviceText = const char* (*)(void*, EGLint);
using PlatformDisplay = EGLDisplay (*)(EGLenum, void*, const EGLint*);

template <typename Signature>
Signature Find(const char* name)
{
  return reinterpret_cast<Signature>(eglGetProcAddress(name));
}

bool Has(const char* extensions, const char* name)
{
  return extensions && std::strstr(extensions, name);
}

// Lists graphics processors first, then devices that draw on the host.
std::vector<void*> ListDevices(const char* extensions)
{
  std::vector<void*> hardware;
  const auto query = Find<Devices>("eglQueryDevicesEXT");
  const auto describe = Find<DeviceText>("eglQueryDeviceStringEXT");
  EGLint count = 0;
  if (!Has(extensions, "EGL_EXT_platform_device") || !query || !describe ||
    !query(0, nullptr, &count) || count <= 0)
  {
    return hardware;
  }
  std::vector<void*> all(static_cast<std::size_t>(count));
  query(count, all.data(), &count);
  all.resize(static_cast<std::size_t>(count));
  std::vector<void*> software;
  for (void* device : all)
  {
    const bool host = Has(describe(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
    (host ? software : hardware).push_back(device);
  }
  hardware.insert(hardware.end(), software.begin(), software.end());
  return hardware;
}

std::string Failed(const char* what)
{
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "%s (EGL error 0x%04x)", what,
    static_cast<unsigned int>(eglGetError()));
  return text.data();
}

} // namespace

namespace skyline
{

bool HeadlessContext::Built()
{
  return true;
}

bool HeadlessContext::Create(int device)
{
  this->Destroy();
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto display = Find<PlatformDisplay>("eglGetPlatformDisplayEXT");
  if (!extensions || !display)
  {
    this->Reason = "EGL has no platforms without a window system";
    return false;
  }
  this->Reason = "EGL lists no device";
  const std::vector<void*> devices = ListDevices(extensions);
  if (device >= 0)
  {
    const auto i = static_cast<std::size_t>(device);
    if (i >= devices.size())
    {
      this->Reason = "EGL has no device " + std::to_string(device) + ", it lists " +
        std::to_string(devices.size());
      return false;
    }
    return this->CreateOn(display(PlatformDevice, devices[i], nullptr));
  }
  for (void* each : devices)
  {
    if (this->CreateOn(display(PlatformDevice, each, nullptr)))
    {
      return true;
    }
  }
  return Has(extensions, "EGL_MESA_platform_surfaceless") &&
    this->CreateOn(display(PlatformSurfaceless, EGL_DEFAULT_DISPLAY, nullptr));
}

bool HeadlessContext::CreateOn(void* display)
{
  EGLint major = 0;
  EGLint minor = 0;
  if (!display || !eglInitialize(display, &major, &minor))
  {
    this->Reason = Failed("EGL cannot open a display");
    return false;
  }
  if (!Has(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
  {
    this->Reason = "EGL offers no context without a surface";
    return false;
  }
  const std::array<EGLint, 5> wanted{ { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
    EGL_OPENGL_BIT, EGL_NONE } };
  const std::array<EGLint, 7> version{ { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE } };
  EGLConfig config = nullptr;
  EGLint configs = 0;
  if (!eglBindAPI(EGL_OPENGL_API) ||
    !eglChooseConfig(display, wanted.data(), &config, 1, &configs) || configs < 1)
  {
    this->Reason = Failed("EGL has no configuration for OpenGL");
    return false;
  }
  this->Context = eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
  if (!this->Context)
  {
    this->Reason = Failed("EGL makes no OpenGL 3.2 core context");
    return false;
  }
  this->Display = display;
  if (!this->MakeCurrent())
  {
    this->Destroy();
    this->Reason = "EGL cannot make its context current without a surface";
    return false;
  }
  this->Reason.clear();
  return true;
}

void HeadlessContext::Destroy()
{
  if (this->Context)
  {
    this->Release();
    // The display is not closed, because other contexts of the process may share it.
    eglDestroyContext(this->Display, this->Context);
  }
  this->Context = nullptr;
  this->Display = nullptr;
}

bool HeadlessContext::MakeCurrent()
{
  return this->Context && eglBindAPI(EGL_OPENGL_API) &&
    eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, this->Context);
}

bool HeadlessContext::IsCurrent() const
{
  return this->Context && eglGetCurrentContext() == this->Context;
}

void HeadlessContext::Release()
{
  if (this->IsCurrent())
  {
    eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
}

HeadlessContext::Function HeadlessContext::FindFunction(const char* name)
{
  return eglGetProcAddress(name);
}

} // namespace skyline

#else

namespace skyline
{

bool HeadlessContext::Built()
{
  return false;
}

bool HeadlessContext::Create(int)
{
  this->Reason = "this build of Skyline has no EGL (libegl-dev was missing)";
  return false;
}

void HeadlessContext::Destroy() {}

bool HeadlessContext::MakeCurrent()
{
  return false;
}

bool HeadlessContext::IsCurrent() const
{
  return false;
}

void HeadlessContext::Release() {}

HeadlessContext::Function HeadlessContext::FindFunction(const char*)
{
  return nullptr;
}

} // namespace skyline

#endif
