// SPDX-License-Identifier: BSD-3-Clause
#include "GpuDevice.h"

#include "OffscreenWindow.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include <array>

namespace skyline
{

GpuDevice::GpuDevice() = default;

GpuDevice::~GpuDevice()
{
  this->Close();
}

void GpuDevice::SetWindow(vtkRenderWindow* window)
{
  if (this->Given != window)
  {
    this->Close();
    this->Given = window;
  }
}

vtkRenderWindow* GpuDevice::GetWindow() const
{
  return this->Given;
}

bool GpuDevice::Open(std::string& reason, bool& renewed)
{
  renewed = !this->ContextGuard || this->ContextGuard->GetHandle() == 0;
  if (!this->Window)
  {
    if (!this->Given && !this->Own)
    {
      this->Own = MakeOffscreenWindow(reason);
    }
    vtkRenderWindow* window = this->Given ? this->Given : this->Own;
    this->Window = vtkOpenGLRenderWindow::SafeDownCast(window);
    if (!this->Window)
    {
      reason = window ? "the render window has no OpenGL" : reason;
      return false;
    }
  }
  if (renewed)
  {
    this->ContextGuard = nullptr;
    this->Frame = nullptr;
    this->Window->Initialize();
  }
  this->Window->MakeCurrent();
  if (!this->Window->IsCurrent() || !glGetString(GL_VERSION))
  {
    reason = "the render window has no OpenGL 3.2 context";
    return false;
  }
  if (renewed)
  {
    this->ContextGuard = this->Image(1, 1, 4);
    this->Frame = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Frame->SetContext(this->Window);
    if (!this->ContextGuard)
    {
      reason = "OpenGL has no memory for textures of floats";
      return false;
    }
  }
  return true;
}

vtkOpenGLRenderWindow* GpuDevice::Context() const
{
  return this->Window;
}

std::string GpuDevice::Name() const
{
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return name ? name : "unknown";
}

int GpuDevice::ImageLimit() const
{
  return vtkTextureObject::GetMaximumTextureSize(this->Window);
}

int GpuDevice::StackLimit() const
{
  return vtkTextureObject::GetMaximumTextureSize3D(this->Window);
}

GpuTexture GpuDevice::Image(int width, int height, int components, const float* values)
{
  auto texture = GpuTexture::New();
  texture->SetContext(this->Window);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  const auto w = static_cast<unsigned int>(width);
  const auto h = static_cast<unsigned int>(height);
  const bool made = values
    ? texture->Create2DFromRaw(w, h, components, VTK_FLOAT, const_cast<float*>(values))
    : texture->Allocate2D(w, h, components, VTK_FLOAT);
  return made ? texture : nullptr;
}

GpuTexture GpuDevice::Stack(int width, int height, int layers, int components)
{
  auto texture = GpuTexture::New();
  texture->SetContext(this->Window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  return texture->Allocate3D(static_cast<unsigned int>(width), static_cast<unsigned int>(height),
           static_cast<unsigned int>(layers), components, VTK_FLOAT)
    ? texture
    : nullptr;
}

void GpuDevice::Read(vtkTextureObject* image, const GpuArea& area, float* values)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  this->Frame->Bind();
  this->Frame->AddColorAttachment(0, image);
  this->Frame->ActivateReadBuffer(0);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(area.X, area.Y, area.Width, area.Height, GL_RGBA, GL_FLOAT, values);
  this->Frame->RemoveColorAttachment(0);
  state->PopFramebufferBindings();
}

void GpuDevice::Finish()
{
  glFinish();
}

void GpuDevice::Close()
{
  this->ContextGuard = nullptr;
  this->Frame = nullptr;
  this->Window = nullptr;
  this->Given = nullptr;
  if (this->Own)
  {
    this->Own->Finalize();
    this->Own = nullptr;
  }
}

struct GpuState::Saved
{
  explicit Saved(vtkOpenGLState* state)
    : Depth(state, GL_DEPTH_TEST)
    , Blend(state, GL_BLEND)
    , Scissor(state, GL_SCISSOR_TEST)
    , Cull(state, GL_CULL_FACE)
    , Stencil(state, GL_STENCIL_TEST)
    , Viewport(state)
    , BlendFactors(state)
    , Mask(state)
    , State(state)
  {
  }
  vtkOpenGLState::ScopedglEnableDisable Depth, Blend, Scissor, Cull, Stencil;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFactors;
  vtkOpenGLState::ScopedglColorMask Mask;
  vtkOpenGLState* State;
};

GpuState::GpuState(const GpuDevice& device)
  : Before(std::make_unique<Saved>(device.Context()->GetState()))
{
  vtkOpenGLState* state = this->Before->State;
  state->PushFramebufferBindings();
  for (const unsigned int name :
    { GL_DEPTH_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE, GL_STENCIL_TEST })
  {
    state->SetEnumState(name, false);
  }
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglBlendFunc(GL_ONE, GL_ONE);
}

GpuState::~GpuState()
{
  this->Before->State->vtkglBlendEquation(GL_FUNC_ADD); // VTK uses this equation everywhere
  this->Before->State->PopFramebufferBindings();
}

GpuPass::GpuPass(GpuDevice& device, const std::string& fragment)
  : Device(device)
  , Quad(std::make_unique<vtkOpenGLQuadHelper>(device.Window, nullptr, fragment.c_str(), nullptr))
{
}

GpuPass::~GpuPass() = default;

bool GpuPass::Use()
{
  if (!this->Quad->Program || !this->Quad->Program->GetCompiled())
  {
    return false;
  }
  this->Device.Window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  return true;
}

void GpuPass::Set(const char* name, vtkTextureObject* texture)
{
  texture->Activate();
  this->Inputs.emplace_back(texture);
  this->Quad->Program->SetUniformi(name, texture->GetTextureUnit());
}

void GpuPass::Set(const char* name, int value)
{
  this->Quad->Program->SetUniformi(name, value);
}

void GpuPass::Set(const char* name, int x, int y)
{
  const std::array<int, 2> values{ { x, y } };
  this->Quad->Program->SetUniform2i(name, values.data());
}

void GpuPass::Set(const char* name, float value)
{
  this->Quad->Program->SetUniformf(name, value);
}

void GpuPass::Set(const char* name, const std::vector<float>& vectors)
{
  this->Quad->Program->SetUniform4fv(name, static_cast<int>(vectors.size() / 4), vectors.data());
}

void GpuPass::Draw(
  const std::vector<vtkTextureObject*>& targets, const GpuArea& area, GpuBlend blend)
{
  this->Device.Frame->Bind();
  unsigned int count = 0;
  for (vtkTextureObject* target : targets)
  {
    this->Device.Frame->AddColorAttachment(count++, target);
  }
  this->DrawBound(count, area, blend);
}

void GpuPass::DrawLayer(vtkTextureObject* stack, int layer, const GpuArea& area)
{
  this->Device.Frame->Bind();
  this->Device.Frame->AddColorAttachment(0, stack, static_cast<unsigned int>(layer));
  this->DrawBound(1, area, GpuBlend::Replace);
}

void GpuPass::DrawBound(unsigned int targets, const GpuArea& area, GpuBlend blend)
{
  vtkOpenGLState* state = this->Device.Window->GetState();
  this->Device.Frame->ActivateDrawBuffers(targets);
  state->SetEnumState(GL_BLEND, blend != GpuBlend::Replace);
  state->vtkglBlendEquation(blend == GpuBlend::Greatest ? GL_MAX : GL_FUNC_ADD);
  state->vtkglViewport(area.X, area.Y, area.Width, area.Height);
  this->Quad->Render();
  // An attachment that is not removed would keep its layer when the next one is added.
  this->Device.Frame->DeactivateDrawBuffers();
  this->Device.Frame->RemoveColorAttachments(targets);
  for (const GpuTexture& input : this->Inputs)
  {
    input->Deactivate();
  }
  this->Inputs.clear();
}

} // namespace skyline
