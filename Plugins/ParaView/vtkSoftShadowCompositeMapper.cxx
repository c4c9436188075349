// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSoftShadowCompositeMapper.h"

#include "vtkSoftShadowShader.h"

#include "vtkActor.h"
#include "vtkCompositeMapperHelper2.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <algorithm>

namespace
{

// Draws the blocks that share a vertex buffer.
class SoftShadowHelper : public vtkCompositeMapperHelper2
{
public:
  static SoftShadowHelper* New();
  vtkTypeMacro(SoftShadowHelper, vtkCompositeMapperHelper2);

  vtkSoftShadowShader* Shader() const
  {
    return static_cast<vtkSoftShadowCompositeMapper*>(this->Parent)->GetShader();
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

  // The light is the shader's alone.
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

} // namespace

vtkStandardNewMacro(vtkSoftShadowCompositeMapper);

vtkSoftShadowCompositeMapper::vtkSoftShadowCompositeMapper()
  : Shader(vtkSmartPointer<vtkSoftShadowShader>::New())
{
}

vtkSoftShadowCompositeMapper::~vtkSoftShadowCompositeMapper() = default;

void vtkSoftShadowCompositeMapper::SetShader(vtkSoftShadowShader* shader)
{
  if (shader && this->Shader != shader)
  {
    this->Shader = shader;
    this->Modified();
  }
}

vtkSoftShadowShader* vtkSoftShadowCompositeMapper::GetShader()
{
  return this->Shader;
}

// A changed light is no change of the mapper: it would build the shader anew.
vtkMTimeType vtkSoftShadowCompositeMapper::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Shader->GetTextTime());
}

void vtkSoftShadowCompositeMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || !this->GetInputDataObject(0, 0) || !this->Shader->GetHeightField())
  {
    return; // nothing delivered to this process
  }
  const auto textures = this->GetTextures(actor);
  this->Shader->SetLinearTextures(std::any_of(textures.begin(), textures.end(),
    [](const auto& texture) { return texture.first && texture.first->GetUseSRGBColorSpace(); }));
  this->Shader->SetLinearFramebuffer(window->GetUsingSRGBColorSpace());
  const std::string reason = this->Shader->Prepare(window);
  if (reason != this->Reported && !reason.empty())
  {
    vtkErrorMacro(<< reason);
  }
  this->Reported = reason;
  if (reason.empty())
  {
    this->Shader->Activate();
    this->Superclass::Render(renderer, actor);
    this->Shader->Deactivate();
  }
}

void vtkSoftShadowCompositeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Shader->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

vtkCompositeMapperHelper2* vtkSoftShadowCompositeMapper::CreateHelper()
{
  return SoftShadowHelper::New();
}

// Far from the origin the places in the textures need all digits that a float has.
void vtkSoftShadowCompositeMapper::CopyMapperValuesToHelper(vtkCompositeMapperHelper2* helper)
{
  this->Superclass::CopyMapperValuesToHelper(helper);
  helper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE);
}

void vtkSoftShadowCompositeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shader: " << this->Shader.GetPointer() << "\n";
}
