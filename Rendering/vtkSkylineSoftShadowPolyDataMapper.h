// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSkylineSoftShadowPolyDataMapper
 * @brief draws a terrain mesh in the light of its height field
 *
 * The mesh is any poly data over the height field, in the same coordinates. It may be decimated. In
 * the mode RECEIVER of the shader, the mesh may stand or fly above the ground, and is lit at its
 * own height.
 *
 * The light comes from a vtkSkylineSoftShadowShader, which computes it for each fragment at the
 * resolution of the height field. VTK's own lights and the specular part of the property have no
 * effect. Colours, colours from scalars, draped textures, opacity, clipping planes, edges, depth
 * peeling and picking work as with other mappers.
 *
 *     vtkNew<vtkSkylineSoftShadowPolyDataMapper> mapper;
 *     mapper->SetInputConnection(mesh->GetOutputPort());
 *     mapper->GetShader()->SetHeightFieldConnection(irradiance->GetOutputPort());
 *
 * If the mesh cannot be drawn, because the renderer has no OpenGL window or because
 * vtkSkylineSoftShadowShader::Prepare fails, the mapper draws nothing and reports the reason once,
 * in one line.
 */
#ifndef vtkSkylineSoftShadowPolyDataMapper_h
#define vtkSkylineSoftShadowPolyDataMapper_h

#include "SkylineRenderingModule.h" // For export macro
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"        // For Shader

#include <map>    // For ReplaceShaderValues
#include <string> // For FragmentShaderText

VTK_ABI_NAMESPACE_BEGIN
class vtkSkylineSoftShadowShader;

class SKYLINERENDERING_EXPORT vtkSkylineSoftShadowPolyDataMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkSkylineSoftShadowPolyDataMapper* New();
  vtkTypeMacro(vtkSkylineSoftShadowPolyDataMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The object that computes the light. Never null: the mapper makes one, and SetShader(nullptr)
   * makes a new one. The mappers of one terrain can share one.
   */
  void SetShader(vtkSkylineSoftShadowShader* shader);
  vtkSkylineSoftShadowShader* GetShader();
  ///@}

  /**
   * Returns the text of the fragment shader that was built last, before VTK adapts it to the
   * context. Empty before the first one is built.
   */
  std::string GetFragmentShaderText();

  /// The time of the last change of this mapper or of its light.
  vtkMTimeType GetMTime() override;

  ///@{
  /// VTK calls these methods for every picture and when a window is closed. Do not call them.
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkSkylineSoftShadowPolyDataMapper();
  ~vtkSkylineSoftShadowPolyDataMapper() override;

  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderLight(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderNormal(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& cells, vtkRenderer* renderer, vtkActor* actor) override;

private:
  int NormalsOf(vtkActor* actor);

  vtkSmartPointer<vtkSkylineSoftShadowShader> Shader;
  std::string FragmentShaderText;
  bool Reported = false; // that there is no context

  vtkSkylineSoftShadowPolyDataMapper(const vtkSkylineSoftShadowPolyDataMapper&) = delete;
  void operator=(const vtkSkylineSoftShadowPolyDataMapper&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
