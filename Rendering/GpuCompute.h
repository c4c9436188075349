// SPDX-License-Identifier: BSD-3-Clause
// Compute shaders on a device with OpenGL 4.3. VTK supports them from version 9.4 on. This code
// calls OpenGL itself, in VTK's context, so that older versions work too.
#ifndef skyline_GpuCompute_h
#define skyline_GpuCompute_h

#include "GpuDevice.h"

#include <cstddef>
#include <string>
#include <vector>

namespace skyline
{

/// A buffer of floats on the graphics processor, not initialized.
class GpuBuffer
{
public:
  explicit GpuBuffer(std::size_t floats);
  ~GpuBuffer();
  GpuBuffer(const GpuBuffer&) = delete;
  GpuBuffer& operator=(const GpuBuffer&) = delete;

  /// Binds the buffer to a binding point of the shader.
  void Bind(unsigned int binding) const;

  /// The greatest number of floats in one buffer that a shader can read.
  static std::size_t Limit();

private:
  unsigned int Handle = 0;
};

class GpuCompute
{
public:
  /// Whether the current context supports compute shaders.
  static bool Known();

  /// Compiles a shader. The text begins after the line with the version. Throws std::runtime_error
  /// with a reason of one line if it cannot be compiled.
  GpuCompute(GpuDevice& device, const std::string& text);
  ~GpuCompute();
  GpuCompute(const GpuCompute&) = delete;
  GpuCompute& operator=(const GpuCompute&) = delete;

  /// Makes the program current. To be called before the methods below. Release gives the context
  /// back to VTK.
  void Use();
  void Set(const char* name, int value);
  void Set(const char* name, int x, int y);
  void Set(const char* name, float value);
  void Set(const char* name, double value);
  void Set(const char* name, double x, double y);
  void Set(const char* name, vtkTextureObject* texture);

  /// Binds an image with one float per texel, which the shader writes.
  void SetImage(unsigned int unit, vtkTextureObject* image);

  /// Runs work groups, and makes what they wrote visible to later commands.
  void Run(int groups);
  void Release();

  /// Reads all texels of an image with one component.
  static void Read(vtkTextureObject* image, float* values);

private:
  int Place(const char* name) const;

  GpuDevice& Device;
  unsigned int Program = 0;
  GpuTexture ContextGuard; // destroyed with the context, like the program
  std::vector<GpuTexture> Inputs;
};

} // namespace skyline

#endif
