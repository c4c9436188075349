// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVHeightFieldSunShadow
 * @brief   vtkHeightFieldSunShadow for ParaView, with a time that can be animated
 *
 * ParaView can animate numbers, but not texts. The sun is where it stands HoursLater after Time.
 */
#ifndef vtkPVHeightFieldSunShadow_h
#define vtkPVHeightFieldSunShadow_h

#include "SkylineParaViewModule.h" // For export macro
#include "vtkHeightFieldSunShadow.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEPARAVIEW_EXPORT vtkPVHeightFieldSunShadow : public vtkHeightFieldSunShadow
{
public:
  static vtkPVHeightFieldSunShadow* New();
  vtkTypeMacro(vtkPVHeightFieldSunShadow, vtkHeightFieldSunShadow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Hours after Time; may be negative. Default: 0.
  vtkSetMacro(HoursLater, double);
  vtkGetMacro(HoursLater, double);
  ///@}

protected:
  vtkPVHeightFieldSunShadow() = default;
  ~vtkPVHeightFieldSunShadow() override = default;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

  double HoursLater = 0.0;

private:
  vtkPVHeightFieldSunShadow(const vtkPVHeightFieldSunShadow&) = delete;
  void operator=(const vtkPVHeightFieldSunShadow&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
