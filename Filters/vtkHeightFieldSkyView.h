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
 *
 * Beyond the data nothing is known, and nothing is assumed: where no terrain lies in a direction its
 * horizon is -90 degrees. So the rim sees too much: on level ground PositiveOpenness is 90, but 135 along
 * an edge and 157.5 at a corner, and hills that the data do not hold hide no sky. `EdgeTrust`, which is
 * off at first, tells where: the share of the azimuths, 0 to 1, in which the data reach at least
 * EdgeDistance from the post (to a post of the surface, or beyond). Holes on the way do not count. Keep
 * posts with EdgeTrust 1, or weigh by it.
 */
#ifndef vtkHeightFieldSkyView_h
#define vtkHeightFieldSkyView_h

#include "vtkHeightFieldAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

namespace skyline
{
struct Grid;
}

VTK_ABI_NAMESPACE_BEGIN
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
  /// Which arrays to add; default all but EdgeTrust. At least one.
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
  vtkSetMacro(EdgeTrust, bool);
  vtkGetMacro(EdgeTrust, bool);
  vtkBooleanMacro(EdgeTrust, bool);
  ///@}

  ///@{
  /// How far the data must reach for EdgeTrust. With AutoEdgeDistance (default on) 1000 metres, or a tenth
  /// of the field's shorter side if that is less; else EdgeDistance: metres, 0 (any terrain at all) or
  /// more, default 1000.
  vtkSetMacro(AutoEdgeDistance, bool);
  vtkGetMacro(AutoEdgeDistance, bool);
  vtkBooleanMacro(AutoEdgeDistance, bool);
  vtkSetMacro(EdgeDistance, double);
  vtkGetMacro(EdgeDistance, double);
  ///@}

protected:
  vtkHeightFieldSkyView() = default;
  ~vtkHeightFieldSkyView() override = default;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

  int NumberOfAzimuths = 72;
  bool SkyViewFactor = true;
  bool SkyViewFactorHorizontal = true;
  bool VisibleSkyFraction = true;
  bool PositiveOpenness = true;
  bool EdgeTrust = false;
  bool AutoEdgeDistance = true;
  double EdgeDistance = 1000.0;

private:
  vtkHeightFieldSkyView(const vtkHeightFieldSkyView&) = delete;
  void operator=(const vtkHeightFieldSkyView&) = delete;

  double UsedEdgeDistance(const skyline::Grid& posts) const;
};
VTK_ABI_NAMESPACE_END

#endif
