// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowCompositeMapper
 * @brief   draws composite data in the light of a vtkSoftShadowShader
 *
 * The mapper of ParaView's surfaces with the shader patch that vtkSoftShadowPolyDataMapper draws with.
 * What cannot be drawn is reported once, in one line; then nothing is drawn.
 */
#ifndef vtkSoftShadowCompositeMapper_h
#define vtkSoftShadowCompositeMapper_h

#include "SkylineParaViewModule.h" // For export macro
#include "vtkCompositePolyDataMapper2.h"
#include "vtkSmartPointer.h" // For Shader

#include <string> // For Reported

class vtkSoftShadowShader;

class SKYLINEPARAVIEW_EXPORT vtkSoftShadowCompositeMapper : public vtkCompositePolyDataMapper2
{
public:
  static vtkSoftShadowCompositeMapper* New();
  vtkTypeMacro(vtkSoftShadowCompositeMapper, vtkCompositePolyDataMapper2);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The light; several mappers may share one. Never null.
  void SetShader(vtkSoftShadowShader* shader);
  vtkSoftShadowShader* GetShader();
  ///@}

  vtkMTimeType GetMTime() override;
  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkSoftShadowCompositeMapper();
  ~vtkSoftShadowCompositeMapper() override;

  vtkCompositeMapperHelper2* CreateHelper() override;
  void CopyMapperValuesToHelper(vtkCompositeMapperHelper2* helper) override;

private:
  vtkSmartPointer<vtkSoftShadowShader> Shader;
  std::string Reported;

  vtkSoftShadowCompositeMapper(const vtkSoftShadowCompositeMapper&) = delete;
  void operator=(const vtkSoftShadowCompositeMapper&) = delete;
};

#endif
