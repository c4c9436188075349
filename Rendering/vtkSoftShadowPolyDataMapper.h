// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSoftShadowPolyDataMapper
 * @brief draws a terrain mesh in the light of its height field
 *
 * The mesh is any poly data over the height field, in the same coordinates. It may be decimated. In
 * the mode RECEIVER of the shader, the mesh may stand or fly above the ground, and is lit at its
 * own height.
 *
 * The light comes from a vtkSoftShadowShader, which computes it for each fragment at the resolution
 * of the height field. VTK's own lights and the specular part of the property have no effect.
 * Colours, colours from scalars, draped textures, opacity, clipping planes, edges, depth peeling
 * and picking work as with other mappers.
 *
 *     vtkNew<vtkSoftShadowPolyDataMapper> mapper;
 *     mapper->SetInputConnection(mesh->GetOutputPort());
 *     mapper->GetShader()->SetHeightFieldConnection(irradiance->GetOutputPort());
 *
 * If the mesh cannot be drawn, because the renderer has no OpenGL window or because
 * vtkSoftShadowShader::Prepare fails, the mapper draws nothing and reports the reason once, in one
 * line.
 */
#ifndef vtkSoftShadowPolyDataMapper_h
#define vtkSoftShadowPolyDataMapper_h

#include "SkylineRenderingModule.h" // For export macro
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSmartPointer.h" // For Shader

#include <map>    // For ReplaceShaderValues
#include <string> // For Reported

class vtkSoftShadowShader;

class SKYLINERENDERING_EXPORT vtkSoftShadowPolyDataMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkSoftShadowPolyDataMapper* New();
  vtkTypeMacro(vtkSoftShadowPolyDataMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The object that computes the light. Never null: the mapper makes one, and SetShader(nullptr)
   * makes a new one. The mappers of one terrain can share one.
   */
  void SetShader(vtkSoftShadowShader* shader);
  vtkSoftShadowShader* GetShader();
  ///@}

  /**
   * Returns the text of the fragment shader that was built last, before VTK adapts it to the
   * context. Empty before the first one is built.
   */
  std::string GetFragmentShaderText();

  vtkMTimeType GetMTime() override;
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkSoftShadowPolyDataMapper();
  ~vtkSoftShadowPolyDataMapper() override;

  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderLight(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderNormal(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& cells, vtkRenderer* renderer, vtkActor* actor) override;

private:
  void Report(const std::string& reason);
  int NormalsOf(vtkActor* actor);

  vtkSmartPointer<vtkSoftShadowShader> Shader;
  std::string FragmentShaderText;
  std::string Reported;

  vtkSoftShadowPolyDataMapper(const vtkSoftShadowPolyDataMapper&) = delete;
  void operator=(const vtkSoftShadowPolyDataMapper&) = delete;
};

#endif
