// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineSoftShadowCompositeMapper
 * @brief   draws composite data in the light of a vtkSkylineSoftShadowShader
 *
 * This is the mapper of ParaView's surfaces with the shader code of
 * vtkSkylineSoftShadowPolyDataMapper. If something cannot be drawn, nothing is drawn, and the
 * reason is reported once, in one line.
 */
#ifndef vtkSkylineSoftShadowCompositeMapper_h
#define vtkSkylineSoftShadowCompositeMapper_h

#include "SkylineParaViewModule.h"  // For export macro
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"        // For Shader
#include "vtkVersionMacros.h"

// ParaView 5.12 and later use another VTK class than 5.11 to draw blocks in batches.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
#else
#include "vtkCompositePolyDataMapper2.h"
#endif

VTK_ABI_NAMESPACE_BEGIN
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
using vtkSkylineSoftShadowCompositeBase = vtkCompositePolyDataMapper;
#else
using vtkSkylineSoftShadowCompositeBase = vtkCompositePolyDataMapper2;
class vtkCompositeMapperHelper2;
#endif

class vtkSkylineSoftShadowShader;

class SKYLINEPARAVIEW_EXPORT vtkSkylineSoftShadowCompositeMapper
  : public vtkSkylineSoftShadowCompositeBase
{
public:
  static vtkSkylineSoftShadowCompositeMapper* New();
  vtkTypeMacro(vtkSkylineSoftShadowCompositeMapper, vtkSkylineSoftShadowCompositeBase);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The light. Several mappers may share one. It is never null.
  void SetShader(vtkSkylineSoftShadowShader* shader);
  vtkSkylineSoftShadowShader* GetShader();
  ///@}

  vtkMTimeType GetMTime() override;
  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkSkylineSoftShadowCompositeMapper();
  ~vtkSkylineSoftShadowCompositeMapper() override;

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  vtkCompositePolyDataMapperDelegator* CreateADelegator() override;
#else
  vtkCompositeMapperHelper2* CreateHelper() override;
  void CopyMapperValuesToHelper(vtkCompositeMapperHelper2* helper) override;
#endif

private:
  vtkSmartPointer<vtkSkylineSoftShadowShader> Shader;

  vtkSkylineSoftShadowCompositeMapper(const vtkSkylineSoftShadowCompositeMapper&) = delete;
  void operator=(const vtkSkylineSoftShadowCompositeMapper&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
