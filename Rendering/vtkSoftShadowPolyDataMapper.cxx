// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowPolyDataMapper.h"

#include "vtkSoftShadowShader.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTexture.h"

#include <algorithm>

vtkStandardNewMacro(vtkSoftShadowPolyDataMapper);

vtkSoftShadowPolyDataMapper::vtkSoftShadowPolyDataMapper()
  : Shader(vtkSmartPointer<vtkSoftShadowShader>::New())
{
  // Far from the origin, texture coordinates need all the digits of a float.
  this->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE);
}

vtkSoftShadowPolyDataMapper::~vtkSoftShadowPolyDataMapper() = default;

void vtkSoftShadowPolyDataMapper::SetShader(vtkSoftShadowShader* shader)
{
  if (this->Shader != shader)
  {
    this->Shader = shader ? vtkSmartPointer<vtkSoftShadowShader>(shader)
                          : vtkSmartPointer<vtkSoftShadowShader>::New();
    this->Modified();
  }
}

vtkSoftShadowShader* vtkSoftShadowPolyDataMapper::GetShader()
{
  return this->Shader;
}

std::string vtkSoftShadowPolyDataMapper::GetFragmentShaderText()
{
  return this->FragmentShaderText;
}

// A change of the lights alone does not modify the mapper, because the mapper would then build its
// shader again.
vtkMTimeType vtkSoftShadowPolyDataMapper::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Shader->GetTextTime());
}

void vtkSoftShadowPolyDataMapper::Report(const std::string& reason)
{
  if (reason != this->Reported && !reason.empty())
  {
    vtkErrorMacro(<< reason);
  }
  this->Reported = reason;
}

void vtkSoftShadowPolyDataMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window =
    renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (!window || !window->IsCurrent())
  {
    this->Report("no OpenGL context to draw the terrain in; the map view of vtkHeightFieldShading "
                 "needs none");
    return;
  }
  const auto textures = this->GetTextures(actor);
  this->Shader->SetLinearTextures(std::any_of(textures.begin(), textures.end(),
    [](const auto& texture) { return texture.first && texture.first->GetUseSRGBColorSpace(); }));
  this->Shader->SetLinearFramebuffer(window->GetUsingSRGBColorSpace());
  const std::string reason = this->Shader->Prepare(window);
  this->Report(reason);
  if (reason.empty())
  {
    this->Superclass::RenderPiece(renderer, actor);
  }
}

void vtkSoftShadowPolyDataMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  this->Shader->Activate();
  this->Superclass::RenderPieceStart(renderer, actor);
}

void vtkSoftShadowPolyDataMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::RenderPieceFinish(renderer, actor);
  this->Shader->Deactivate();
}

void vtkSoftShadowPolyDataMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Shader->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

// The type of normals of the primitives whose shader is being built.
int vtkSoftShadowPolyDataMapper::NormalsOf(vtkActor* actor)
{
  const bool faces = actor->GetProperty()->GetRepresentation() == VTK_SURFACE &&
    this->LastBoundBO->PrimitiveType >= PrimitiveTris;
  return this->VBOs->GetNumberOfComponents("normalMC") == 3 ? vtkSoftShadowShader::POINTS
    : faces                                                 ? vtkSoftShadowShader::FACES
                                                            : vtkSoftShadowShader::NONE;
}

void vtkSoftShadowPolyDataMapper::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  this->Shader->ReplaceShaderValues(shaders, this->NormalsOf(actor));
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
  this->FragmentShaderText = shaders[vtkShader::Fragment]->GetSource();
}

// All light comes from vtkSoftShadowShader.
void vtkSoftShadowPolyDataMapper::ReplaceShaderLight(
  std::map<vtkShader::Type, vtkShader*>, vtkRenderer*, vtkActor*)
{
}

// In the mode RECEIVER, vtkSoftShadowShader computes the normals.
void vtkSoftShadowPolyDataMapper::ReplaceShaderNormal(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  if (this->Shader->GetMode() != vtkSoftShadowShader::RECEIVER)
  {
    this->Superclass::ReplaceShaderNormal(shaders, renderer, actor);
  }
}

void vtkSoftShadowPolyDataMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cells, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(cells, renderer, actor);
  this->Shader->SetPlacement(actor->GetIsIdentity() ? nullptr : actor->GetMatrix());
  this->Shader->SetUniforms(cells.Program, this->VBOs);
}

void vtkSoftShadowPolyDataMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shader: " << this->Shader.GetPointer() << "\n";
}
