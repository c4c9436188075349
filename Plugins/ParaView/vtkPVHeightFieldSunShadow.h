// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVHeightFieldSunShadow
 * @brief   vtkHeightFieldSunShadow with a time that ParaView can animate
 *
 * ParaView animates numbers, not texts: the sun stands where it does HoursLater after Time.
 */
#ifndef vtkPVHeightFieldSunShadow_h
#define vtkPVHeightFieldSunShadow_h

#include "SkylineParaViewModule.h" // For export macro
#include "vtkHeightFieldSunShadow.h"

class SKYLINEPARAVIEW_EXPORT vtkPVHeightFieldSunShadow : public vtkHeightFieldSunShadow
{
public:
  static vtkPVHeightFieldSunShadow* New();
  vtkTypeMacro(vtkPVHeightFieldSunShadow, vtkHeightFieldSunShadow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Hours after Time, also negative; default 0.
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

#endif
