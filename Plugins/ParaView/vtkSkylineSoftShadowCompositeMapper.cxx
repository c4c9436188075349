// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineSoftShadowCompositeMapper.h"

#include "vtkSkylineSoftShadowShader.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <algorithm>

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkOpenGLBatchedPolyDataMapper.h"
#include "vtkOpenGLCompositePolyDataMapperDelegator.h"
#else
#include "vtkCompositeMapperHelper2.h"
#endif

namespace
{

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
using HelperBase = vtkOpenGLBatchedPolyDataMapper;
#else
using HelperBase = vtkCompositeMapperHelper2;
#endif

// Draws the blocks that share a vertex buffer.
class SoftShadowHelper : public HelperBase
{
public:
  static SoftShadowHelper* New();
  vtkTypeMacro(SoftShadowHelper, HelperBase);

  vtkSkylineSoftShadowShader* Shader() const
  {
    return static_cast<vtkSkylineSoftShadowCompositeMapper*>(this->Parent)->GetShader();
  }

  vtkMTimeType GetMTime() override
  {
    const vtkMTimeType time = this->Superclass::GetMTime();
    return this->Parent ? std::max(time, this->Shader()->GetTextTime()) : time;
  }

protected:
  SoftShadowHelper() = default;
  ~SoftShadowHelper() override = default;

  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override
  {
    this->Shader()->ReplaceShaderValues(shaders);
    this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
  }

  // Only the shader computes light.
  void ReplaceShaderLight(std::map<vtkShader::Type, vtkShader*>, vtkRenderer*, vtkActor*) override
  {
  }

  void SetMapperShaderParameters(
    vtkOpenGLHelper& cells, vtkRenderer* renderer, vtkActor* actor) override
  {
    this->Superclass::SetMapperShaderParameters(cells, renderer, actor);
    this->Shader()->SetUniforms(cells.Program, this->VBOs);
  }

private:
  SoftShadowHelper(const SoftShadowHelper&) = delete;
  void operator=(const SoftShadowHelper&) = delete;
};

vtkStandardNewMacro(SoftShadowHelper);

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
// Replaces VTK's helper by SoftShadowHelper.
class SoftShadowDelegator : public vtkOpenGLCompositePolyDataMapperDelegator
{
public:
  static SoftShadowDelegator* New();
  vtkTypeMacro(SoftShadowDelegator, vtkOpenGLCompositePolyDataMapperDelegator);

  void ShallowCopy(vtkCompositePolyDataMapper* mapper) override
  {
    this->Superclass::ShallowCopy(mapper);
    this->GLDelegate->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE);
  }

protected:
  SoftShadowDelegator()
  {
    this->GLDelegate = SoftShadowHelper::New();
    this->Delegate.TakeReference(this->GLDelegate);
  }
  ~SoftShadowDelegator() override = default;

private:
  SoftShadowDelegator(const SoftShadowDelegator&) = delete;
  void operator=(const SoftShadowDelegator&) = delete;
};

vtkStandardNewMacro(SoftShadowDelegator);
#endif

bool IsLinear(vtkTexture* texture)
{
  return texture && texture->GetUseSRGBColorSpace();
}

// True if OpenGL converts a texture of the actor to linear light.
bool HasLinearTexture(vtkActor* actor)
{
  const auto& textures = actor->GetProperty()->GetAllTextures();
  return IsLinear(actor->GetTexture()) ||
    std::any_of(textures.begin(), textures.end(),
      [](const auto& texture) { return IsLinear(texture.second); });
}

} // namespace

vtkStandardNewMacro(vtkSkylineSoftShadowCompositeMapper);

vtkSkylineSoftShadowCompositeMapper::vtkSkylineSoftShadowCompositeMapper()
  : Shader(vtkSmartPointer<vtkSkylineSoftShadowShader>::New())
{
}

vtkSkylineSoftShadowCompositeMapper::~vtkSkylineSoftShadowCompositeMapper() = default;

void vtkSkylineSoftShadowCompositeMapper::SetShader(vtkSkylineSoftShadowShader* shader)
{
  if (shader && this->Shader != shader)
  {
    this->Shader = shader;
    this->Modified();
  }
}

vtkSkylineSoftShadowShader* vtkSkylineSoftShadowCompositeMapper::GetShader()
{
  return this->Shader;
}

// A change of the light does not change the mapper, which would otherwise build its shader again.
vtkMTimeType vtkSkylineSoftShadowCompositeMapper::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Shader->GetTextTime());
}

void vtkSkylineSoftShadowCompositeMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || !this->GetInputDataObject(0, 0) || !this->Shader->GetHeightField())
  {
    return; // this process received nothing
  }
  this->Shader->SetLinearTextures(HasLinearTexture(actor));
  this->Shader->SetLinearFramebuffer(window->GetUsingSRGBColorSpace());
  if (this->Shader->Prepare(window))
  {
    this->Shader->Activate();
    this->Superclass::Render(renderer, actor);
    this->Shader->Deactivate();
  }
}

void vtkSkylineSoftShadowCompositeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Shader->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

// Far from the origin, the coordinates in the textures need the full precision of a float.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
vtkCompositePolyDataMapperDelegator* vtkSkylineSoftShadowCompositeMapper::CreateADelegator()
{
  return SoftShadowDelegator::New();
}
#else
vtkCompositeMapperHelper2* vtkSkylineSoftShadowCompositeMapper::CreateHelper()
{
  return SoftShadowHelper::New();
}

void vtkSkylineSoftShadowCompositeMapper::CopyMapperValuesToHelper(
  vtkCompositeMapperHelper2* helper)
{
  this->Superclass::CopyMapperValuesToHelper(helper);
  helper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE);
}
#endif

void vtkSkylineSoftShadowCompositeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shader: " << this->Shader.GetPointer() << "\n";
}
