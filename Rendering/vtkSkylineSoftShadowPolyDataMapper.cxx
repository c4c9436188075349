// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineSoftShadowPolyDataMapper.h"

#include "vtkSkylineSoftShadowShader.h"

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

vtkStandardNewMacro(vtkSkylineSoftShadowPolyDataMapper);

vtkSkylineSoftShadowPolyDataMapper::vtkSkylineSoftShadowPolyDataMapper()
  : Shader(vtkSmartPointer<vtkSkylineSoftShadowShader>::New())
{
  // Far from the origin, texture coordinates need all the digits of a float.
  this->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE);
}

vtkSkylineSoftShadowPolyDataMapper::~vtkSkylineSoftShadowPolyDataMapper() = default;

void vtkSkylineSoftShadowPolyDataMapper::SetShader(vtkSkylineSoftShadowShader* shader)
{
  if (this->Shader != shader)
  {
    this->Shader = shader ? vtkSmartPointer<vtkSkylineSoftShadowShader>(shader)
                          : vtkSmartPointer<vtkSkylineSoftShadowShader>::New();
    this->Modified();
  }
}

vtkSkylineSoftShadowShader* vtkSkylineSoftShadowPolyDataMapper::GetShader()
{
  return this->Shader;
}

std::string vtkSkylineSoftShadowPolyDataMapper::GetFragmentShaderText()
{
  return this->FragmentShaderText;
}

// A change of the lights alone does not modify the mapper, because the mapper would then build its
// shader again.
vtkMTimeType vtkSkylineSoftShadowPolyDataMapper::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Shader->GetTextTime());
}

void vtkSkylineSoftShadowPolyDataMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window =
    renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (!window || !window->IsCurrent())
  {
    if (!this->Reported)
    {
      vtkErrorMacro(
        "no OpenGL context to draw the terrain in; the map view of vtkHeightFieldShading "
        "needs none");
    }
    this->Reported = true;
    return;
  }
  this->Reported = false;
  const auto textures = this->GetTextures(actor);
  this->Shader->SetLinearTextures(std::any_of(textures.begin(), textures.end(),
    [](const auto& texture) { return texture.first && texture.first->GetUseSRGBColorSpace(); }));
  this->Shader->SetLinearFramebuffer(window->GetUsingSRGBColorSpace());
  if (this->Shader->Prepare(window))
  {
    this->Superclass::RenderPiece(renderer, actor);
  }
}

void vtkSkylineSoftShadowPolyDataMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  this->Shader->Activate();
  this->Superclass::RenderPieceStart(renderer, actor);
}

void vtkSkylineSoftShadowPolyDataMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::RenderPieceFinish(renderer, actor);
  this->Shader->Deactivate();
}

void vtkSkylineSoftShadowPolyDataMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Shader->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

// The type of normals of the primitives whose shader is being built.
int vtkSkylineSoftShadowPolyDataMapper::NormalsOf(vtkActor* actor)
{
  const bool faces = actor->GetProperty()->GetRepresentation() == VTK_SURFACE &&
    this->LastBoundBO->PrimitiveType >= PrimitiveTris;
  return this->VBOs->GetNumberOfComponents("normalMC") == 3 ? vtkSkylineSoftShadowShader::POINTS
    : faces                                                 ? vtkSkylineSoftShadowShader::FACES
                                                            : vtkSkylineSoftShadowShader::NONE;
}

void vtkSkylineSoftShadowPolyDataMapper::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  this->Shader->ReplaceShaderValues(shaders, this->NormalsOf(actor));
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
  this->FragmentShaderText = shaders[vtkShader::Fragment]->GetSource();
}

// All light comes from vtkSkylineSoftShadowShader.
void vtkSkylineSoftShadowPolyDataMapper::ReplaceShaderLight(
  std::map<vtkShader::Type, vtkShader*>, vtkRenderer*, vtkActor*)
{
}

// In the mode RECEIVER, vtkSkylineSoftShadowShader computes the normals.
void vtkSkylineSoftShadowPolyDataMapper::ReplaceShaderNormal(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  if (this->Shader->GetMode() != vtkSkylineSoftShadowShader::RECEIVER)
  {
    this->Superclass::ReplaceShaderNormal(shaders, renderer, actor);
  }
}

void vtkSkylineSoftShadowPolyDataMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cells, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(cells, renderer, actor);
  this->Shader->SetPlacement(actor->GetIsIdentity() ? nullptr : actor->GetMatrix());
  this->Shader->SetUniforms(cells.Program, this->VBOs);
}

void vtkSkylineSoftShadowPolyDataMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shader: " << this->Shader.GetPointer() << "\n";
}
