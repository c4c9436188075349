// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSoftShadowCompositeMapper
 * @brief   draws composite data in the light of a vtkSoftShadowShader
 *
 * This is the mapper of ParaView's surfaces with the shader code of vtkSoftShadowPolyDataMapper. If
 * something cannot be drawn, nothing is drawn, and the reason is reported once, in one line.
 */
#ifndef vtkSoftShadowCompositeMapper_h
#define vtkSoftShadowCompositeMapper_h

#include "SkylineParaViewModule.h" // For export macro
#include "vtkSmartPointer.h"       // For Shader
#include "vtkVersionMacros.h"

#include <string> // For Reported

// ParaView 5.12 and later use another VTK class than 5.11 to draw blocks in batches.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
using vtkSoftShadowCompositeBase = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using vtkSoftShadowCompositeBase = vtkCompositePolyDataMapper2;
class vtkCompositeMapperHelper2;
#endif

class vtkSoftShadowShader;

class SKYLINEPARAVIEW_EXPORT vtkSoftShadowCompositeMapper : public vtkSoftShadowCompositeBase
{
public:
  static vtkSoftShadowCompositeMapper* New();
  vtkTypeMacro(vtkSoftShadowCompositeMapper, vtkSoftShadowCompositeBase);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The light. Several mappers may share one. It is never null.
  void SetShader(vtkSoftShadowShader* shader);
  vtkSoftShadowShader* GetShader();
  ///@}

  vtkMTimeType GetMTime() override;
  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkSoftShadowCompositeMapper();
  ~vtkSoftShadowCompositeMapper() override;

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  vtkCompositePolyDataMapperDelegator* CreateADelegator() override;
#else
  vtkCompositeMapperHelper2* CreateHelper() override;
  void CopyMapperValuesToHelper(vtkCompositeMapperHelper2* helper) override;
#endif

private:
  vtkSmartPointer<vtkSoftShadowShader> Shader;
  std::string Reported;

  vtkSoftShadowCompositeMapper(const vtkSoftShadowCompositeMapper&) = delete;
  void operator=(const vtkSoftShadowCompositeMapper&) = delete;
};

#endif
