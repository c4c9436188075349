// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldSkyLight
 * @brief   how much light of an overcast sky every post gets
 *
 * Adds the float array `SkyLight`: irradiance of the post's tilted surface by the part of the sky
 * that it sees, over that of open level ground under the same sky: 1 there, 0 in a chasm. The sky's
 * radiance depends on elevation alone; with the uniform sky this is SkyViewFactor. No
 * horizon is stored.
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
  /// Azimuths around; default 72, 1 to 3600.
  vtkSetMacro(NumberOfAzimuths, int);
  vtkGetMacro(NumberOfAzimuths, int);
  ///@}

  ///@{
  /// The sky by its number in CIE S 011: 1 overcast (default), 3 overcast with a moderate
  /// gradation, 5 uniform, 16 the traditional overcast sky. Others are an error of the update.
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
