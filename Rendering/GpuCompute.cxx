// SPDX-License-Identifier: BSD-3-Clause
#include "GpuCompute.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include <array>
#include <stdexcept>

namespace skyline
{

GpuBuffer::GpuBuffer(std::size_t floats)
{
  while (glGetError() != GL_NO_ERROR) // clears the errors of earlier calls
  {
  }
  glGenBuffers(1, &this->Handle);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handle);
  glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(floats * sizeof(float)), nullptr,
    GL_DYNAMIC_COPY);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  if (glGetError() != GL_NO_ERROR)
  {
    glDeleteBuffers(1, &this->Handle);
    throw std::runtime_error("OpenGL has no memory for a buffer");
  }
}

GpuBuffer::~GpuBuffer()
{
  glDeleteBuffers(1, &this->Handle);
}

void GpuBuffer::Bind(unsigned int binding) const
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, this->Handle);
}

std::size_t GpuBuffer::Limit()
{
  GLint bytes = 0;
  glGetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  return static_cast<std::size_t>(bytes) / sizeof(float);
}

bool GpuCompute::Known()
{
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  return major > 4 || (major == 4 && minor >= 3);
}

GpuCompute::GpuCompute(GpuDevice& device, const std::string& text)
  : Device(device)
  , ContextGuard(device.Image(1, 1, 1))
{
  const std::string whole = "#version 430\n" + text;
  const char* lines = whole.c_str();
  const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
  glShaderSource(shader, 1, &lines, nullptr);
  glCompileShader(shader);
  this->Program = glCreateProgram();
  glAttachShader(this->Program, shader);
  glLinkProgram(this->Program);
  glDeleteShader(shader);
  GLint built = GL_FALSE;
  glGetProgramiv(this->Program, GL_LINK_STATUS, &built);
  if (built != GL_TRUE)
  {
    std::array<char, 512> log{};
    glGetProgramInfoLog(this->Program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    glDeleteProgram(this->Program);
    const std::string reason(log.data());
    throw std::runtime_error(
      "OpenGL cannot build a compute shader: " + reason.substr(0, reason.find('\n')));
  }
}

GpuCompute::~GpuCompute()
{
  if (this->ContextGuard && this->ContextGuard->GetHandle() != 0)
  {
    this->ContextGuard->GetContext()->MakeCurrent();
    glDeleteProgram(this->Program);
  }
}

void GpuCompute::Use()
{
  this->Device.Context()->GetShaderCache()->ReleaseCurrentShader();
  glUseProgram(this->Program);
}

int GpuCompute::Place(const char* name) const
{
  return glGetUniformLocation(this->Program, name);
}

void GpuCompute::Set(const char* name, int value)
{
  glUniform1i(this->Place(name), value);
}

void GpuCompute::Set(const char* name, int x, int y)
{
  glUniform2i(this->Place(name), x, y);
}

void GpuCompute::Set(const char* name, float value)
{
  glUniform1f(this->Place(name), value);
}

void GpuCompute::Set(const char* name, double value)
{
  glUniform1d(this->Place(name), value);
}

void GpuCompute::Set(const char* name, double x, double y)
{
  glUniform2d(this->Place(name), x, y);
}

void GpuCompute::Set(const char* name, vtkTextureObject* texture)
{
  texture->Activate();
  this->Inputs.emplace_back(texture);
  glUniform1i(this->Place(name), texture->GetTextureUnit());
}

void GpuCompute::SetImage(unsigned int unit, vtkTextureObject* image)
{
  glBindImageTexture(unit, image->GetHandle(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32F);
}

void GpuCompute::Run(int groups)
{
  glDispatchCompute(static_cast<GLuint>(groups), 1, 1);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

void GpuCompute::Release()
{
  for (const GpuTexture& input : this->Inputs)
  {
    input->Deactivate();
  }
  this->Inputs.clear();
  glUseProgram(0);
}

void GpuCompute::Read(vtkTextureObject* image, float* values)
{
  image->Activate();
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, values);
  image->Deactivate();
}

} // namespace skyline
