// SPDX-License-Identifier: BSD-3-Clause
// Affine maps of positions, for vertices as VTK stores them in its buffers.
#ifndef skyline_VertexRow_h
#define skyline_VertexRow_h

#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkShaderProgram.h"

#include <array>
#include <cstddef>

namespace skyline
{

/// A row of a matrix that transforms (x, y, z, 1).
using VertexRow = std::array<double, 4>;

/// Sets a uniform to the row that applies to the vertices of the buffer, which holds (position -
/// shift) * scale.
inline void SetVertexRow(vtkShaderProgram* program, vtkOpenGLVertexBufferObjectGroup* buffers,
  const char* name, const VertexRow& row)
{
  vtkOpenGLVertexBufferObject* vertices = buffers->GetVBO("vertexMC");
  const bool shifted = vertices && vertices->GetCoordShiftAndScaleEnabled() &&
    vertices->GetShift().size() >= 3 && vertices->GetScale().size() >= 3;
  VertexRow adapted = row;
  for (std::size_t k = 0; k < 3 && shifted; ++k)
  {
    adapted[3] += row[k] * vertices->GetShift()[k];
    adapted[k] = row[k] / vertices->GetScale()[k];
  }
  const std::array<float, 4> numbers{ { static_cast<float>(adapted[0]),
    static_cast<float>(adapted[1]), static_cast<float>(adapted[2]),
    static_cast<float>(adapted[3]) } };
  program->SetUniform4f(name, numbers.data());
}

} // namespace skyline

#endif
