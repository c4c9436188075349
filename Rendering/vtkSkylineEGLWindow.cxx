// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineEGLWindow.h"

#include "HeadlessContext.h"

#include "vtkObjectFactory.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
#include "vtk_glew.h"
#endif

#include <algorithm>

vtkStandardNewMacro(vtkSkylineEGLWindow);

vtkSkylineEGLWindow::vtkSkylineEGLWindow()
  : Context(std::make_unique<skyline::HeadlessContext>())
{
  this->SetMapped(1);
  this->SetOwnContext(1);
  this->MultiSamples = 0;
  this->FrameBlitMode = NoBlit; // there is no screen behind VTK's framebuffer
  this->ScreenSize[0] = this->ScreenSize[1] = 16384;
}

vtkSkylineEGLWindow::~vtkSkylineEGLWindow()
{
  this->Finalize();
}

bool vtkSkylineEGLWindow::IsSupported()
{
  skyline::HeadlessContext probe;
  return probe.Create(-1);
}

std::string vtkSkylineEGLWindow::GetReason()
{
  return this->Context->GetReason();
}

// Makes the context if it does not exist. Reports a failure only once.
bool vtkSkylineEGLWindow::Ready()
{
  if (this->Context->Exists() || this->Failed)
  {
    return this->Context->Exists();
  }
  if (!this->Context->Create(this->Device))
  {
    this->Failed = true;
    vtkErrorMacro("no OpenGL without a window system: " << this->Context->GetReason());
    return false;
  }
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  this->SetOpenGLSymbolLoader(
    [](void*, const char* name) { return skyline::HeadlessContext::FindFunction(name); }, nullptr);
#endif
  this->OpenGLInit();
  return true;
}

void vtkSkylineEGLWindow::Initialize()
{
  this->Ready();
}

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
// Debian's GLEW is built for GLX. It finds all functions through the dispatch library, which EGL
// shares, and then reports that there is no X display. Skyline needs none, so this error is
// ignored.
void vtkSkylineEGLWindow::OpenGLInitContext()
{
  if (!this->Initialized)
  {
    const GLenum result = glewInit();
    bool found = result == GLEW_OK;
#ifdef GLEW_ERROR_NO_GLX_DISPLAY
    found = found || result == GLEW_ERROR_NO_GLX_DISPLAY;
#endif
    if (!found || !GLEW_VERSION_3_2)
    {
      vtkErrorMacro("no OpenGL 3.2 in the context that EGL made");
      return;
    }
    this->GlewInitValid = true;
    this->Initialized = true;
    GLfloat range[2] = { 1.0f, 1.0f };
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
    this->MaximumHardwareLineWidth = range[1];
  }
  this->Superclass::OpenGLInitContext();
}
#endif

void vtkSkylineEGLWindow::Render()
{
  if (!this->Ready())
  {
    return;
  }
  this->MakeCurrent();
  if (!this->Context->IsCurrent())
  {
    vtkErrorMacro("the OpenGL context is lost; Finalize the window and render again");
    return;
  }
  this->Superclass::Render();
}

void vtkSkylineEGLWindow::Finalize()
{
  if (this->Context->Exists() && this->Context->MakeCurrent())
  {
    this->Superclass::Finalize();
  }
  this->Context->Destroy();
  this->Initialized = false;
  this->Failed = false;
}

void vtkSkylineEGLWindow::MakeCurrent()
{
  if (this->Context->Exists() && !this->Context->IsCurrent())
  {
    this->Context->MakeCurrent();
  }
}

bool vtkSkylineEGLWindow::IsCurrent()
{
  return this->Context->IsCurrent();
}

int vtkSkylineEGLWindow::SupportsOpenGL()
{
  return this->Ready() ? 1 : 0;
}

vtkTypeBool vtkSkylineEGLWindow::IsDirect()
{
  return 1;
}

// VTK asks for the bits of the default framebuffer, which has none here. These are the bits of
// VTK's own framebuffers.
int vtkSkylineEGLWindow::GetColorBufferSizes(int* rgba)
{
  if (rgba == nullptr)
  {
    return 0;
  }
  std::fill_n(rgba, 4, 8);
  return 32;
}

void vtkSkylineEGLWindow::ReleaseCurrent()
{
  this->Context->Release();
}

void vtkSkylineEGLWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Device: " << this->Device << "\n";
  os << indent << "Reason: " << this->GetReason() << "\n";
}
