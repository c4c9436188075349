// SPDX-License-Identifier: BSD-3-Clause
// Compute shaders on a device of OpenGL 4.3. VTK knows them from 9.4 on; before that, OpenGL's own calls
// do in VTK's context.
#ifndef skyline_GpuCompute_h
#define skyline_GpuCompute_h

#include "GpuDevice.h"

#include <cstddef>
#include <string>
#include <vector>

namespace skyline
{

/// Floats in a buffer of the graphics processor, not set.
class GpuBuffer
{
public:
  explicit GpuBuffer(std::size_t floats);
  ~GpuBuffer();
  GpuBuffer(const GpuBuffer&) = delete;
  GpuBuffer& operator=(const GpuBuffer&) = delete;

  /// To the binding that the shader names.
  void Bind(unsigned int binding) const;

  /// Floats that a shader may see in one buffer.
  static std::size_t Limit();

private:
  unsigned int Handle = 0;
};

class GpuCompute
{
public:
  /// Whether the current context has compute shaders.
  static bool Known();

  /// The text begins after the version. std::runtime_error in one line, where it cannot be built.
  GpuCompute(GpuDevice& device, const std::string& text);
  ~GpuCompute();
  GpuCompute(const GpuCompute&) = delete;
  GpuCompute& operator=(const GpuCompute&) = delete;

  /// Before what follows; Release afterwards gives the context back to VTK.
  void Use();
  void Set(const char* name, int value);
  void Set(const char* name, int x, int y);
  void Set(const char* name, float value);
  void Set(const char* name, double value);
  void Set(const char* name, double x, double y);
  void Set(const char* name, vtkTextureObject* texture);

  /// An image of one float a texel, to write into.
  void SetImage(unsigned int unit, vtkTextureObject* image);

  /// Runs work groups, and lets what comes after see what they wrote.
  void Run(int groups);
  void Release();

  /// All texels of an image of one component.
  static void Read(vtkTextureObject* image, float* values);

private:
  int Place(const char* name) const;

  GpuDevice& Device;
  unsigned int Program = 0;
  GpuTexture Sentinel; // gone with the context, as the program is
  std::vector<GpuTexture> Inputs;
};

} // namespace skyline

#endif
