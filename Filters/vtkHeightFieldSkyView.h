// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldSkyView
 * @brief   how much sky every post sees
 *
 * Adds the float arrays that are switched on. Sky is what lies above max(horizon, 0).
 * `SkyViewFactor`: cosine-weighted, on the tilted surface (and above its plane), 0 to 1;
 * `SkyViewFactorHorizontal`: the same on a level surface; `VisibleSkyFraction`: solid angle over that
 * of the upper hemisphere; `PositiveOpenness`: mean zenith angle of the horizon, degrees, 0 to 180.
 * No horizon is stored: memory stays below 10 floats a post.
 */
#ifndef vtkHeightFieldSkyView_h
#define vtkHeightFieldSkyView_h

#include "vtkHeightFieldAlgorithm.h"

class SKYLINEFILTERS_EXPORT vtkHeightFieldSkyView : public vtkHeightFieldAlgorithm
{
public:
  static vtkHeightFieldSkyView* New();
  vtkTypeMacro(vtkHeightFieldSkyView, vtkHeightFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Azimuths around; default 72, 1 to 3600.
  vtkSetMacro(NumberOfAzimuths, int);
  vtkGetMacro(NumberOfAzimuths, int);
  ///@}

  ///@{
  /// Which arrays to add; default all. At least one.
  vtkSetMacro(SkyViewFactor, bool);
  vtkGetMacro(SkyViewFactor, bool);
  vtkBooleanMacro(SkyViewFactor, bool);
  vtkSetMacro(SkyViewFactorHorizontal, bool);
  vtkGetMacro(SkyViewFactorHorizontal, bool);
  vtkBooleanMacro(SkyViewFactorHorizontal, bool);
  vtkSetMacro(VisibleSkyFraction, bool);
  vtkGetMacro(VisibleSkyFraction, bool);
  vtkBooleanMacro(VisibleSkyFraction, bool);
  vtkSetMacro(PositiveOpenness, bool);
  vtkGetMacro(PositiveOpenness, bool);
  vtkBooleanMacro(PositiveOpenness, bool);
  ///@}

protected:
  bool Compute(skyline::HorizonScene& scene, vtkImageData* output) override;

  int NumberOfAzimuths = 72;
  bool SkyViewFactor = true;
  bool SkyViewFactorHorizontal = true;
  bool VisibleSkyFraction = true;
  bool PositiveOpenness = true;
};

#endif
