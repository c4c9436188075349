// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineSoftShadowCompositeMapper
 * @brief   draws composite data in the light of a vtkSkylineSoftShadowShader
 *
 * The mapper of ParaView's surfaces with the shader patch that vtkSkylineSoftShadowPolyDataMapper draws with.
 * What cannot be drawn is reported once, in one line; then nothing is drawn.
 */
#ifndef vtkSkylineSoftShadowCompositeMapper_h
#define vtkSkylineSoftShadowCompositeMapper_h

#include "SkylineParaViewModule.h"  // For export macro
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"        // For Shader
#include "vtkVersionMacros.h"

// ParaView 5.12 and later batch the blocks by another class of VTK than 5.11.
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
  /// The light; several mappers may share one. Never null.
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
