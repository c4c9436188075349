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

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "SkylineParaViewModule.h" // For export macro
#include "vtkSmartPointer.h"       // For Shader
#include "vtkVersionMacros.h"

#include <string> // For Reported

// ParaView 5.12 and later batch the blocks by another class of VTK than 5.11.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
#else
#include "vtkCompositePolyDataMapper2.h"
#endif

VTK_ABI_NAMESPACE_BEGIN
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
using vtkSoftShadowCompositeBase = vtkCompositePolyDataMapper;
#else
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
VTK_ABI_NAMESPACE_END

#endif
