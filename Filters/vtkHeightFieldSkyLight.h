// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldSkyLight
 * @brief   computes how much light of an overcast sky reaches each post
 *
 * Adds the float array `SkyLight`: the irradiance of the tilted surface at the post from the part
 * of the sky that it sees, divided by the irradiance of open level ground under the same sky. It is
 * 1 on open level ground, and 0 where no sky is seen. The radiance of the sky depends on elevation
 * only; for the uniform sky the result is SkyViewFactor. No horizon is stored.
 */
#ifndef vtkHeightFieldSkyLight_h
#define vtkHeightFieldSkyLight_h

#include "SkylineFiltersModule.h" // for the export macro
#include "vtkHeightFieldAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkHeightFieldSkyLight : public vtkHeightFieldAlgorithm
{
public:
  static vtkHeightFieldSkyLight* New();
  vtkTypeMacro(vtkHeightFieldSkyLight, vtkHeightFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Set/Get the number of evenly spaced azimuths. The default is 72, the range 1 to 3600. Other
  /// values are an error of the update.
  vtkSetMacro(NumberOfAzimuths, int);
  vtkGetMacro(NumberOfAzimuths, int);
  ///@}

  ///@{
  /// Set/Get the number of the sky in CIE S 011: 1 overcast (default), 3 overcast with a moderate
  /// gradation, 5 uniform, 16 the traditional overcast sky. Other values are an error of the
  /// update.
  vtkSetMacro(CieType, int);
  vtkGetMacro(CieType, int);
  ///@}

protected:
  vtkHeightFieldSkyLight() = default;
  ~vtkHeightFieldSkyLight() override = default;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

  int NumberOfAzimuths = 72;
  int CieType = 1;

private:
  vtkHeightFieldSkyLight(const vtkHeightFieldSkyLight&) = delete;
  void operator=(const vtkHeightFieldSkyLight&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
