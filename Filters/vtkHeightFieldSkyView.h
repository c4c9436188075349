// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldSkyView
 * @brief   computes how much of the sky each post sees
 *
 * Adds the float arrays that are switched on. Sky is what lies above max(horizon, 0).
 * - `SkyViewFactor`: the cosine-weighted share of the sky for the tilted surface at the post, where
 *   only sky above its own plane counts, 0 to 1.
 * - `SkyViewFactorHorizontal`: the same for a level surface.
 * - `VisibleSkyFraction`: the solid angle of the visible sky divided by that of the upper
 *   hemisphere.
 * - `PositiveOpenness`: the mean zenith angle of the horizon in degrees, 0 to 180.
 *
 * No horizon is stored; the filter needs fewer than 10 floats per post.
 *
 * Nothing is assumed beyond the edge of the data: where no terrain lies in a direction, the horizon
 * there is -90 degrees. Therefore posts near the edge see too much sky: on level ground
 * PositiveOpenness is 90, but 135 along an edge and 157.5 at a corner; and hills outside the data
 * hide no sky. `EdgeTrust` (off by default) shows where: it is the share of the azimuths, 0 to 1,
 * in which the data reach at least EdgeDistance from the post. Holes in between do not count. Use
 * only posts with EdgeTrust 1, or weight by it.
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
  /// Set/Get the number of evenly spaced azimuths. The default is 72, the range 1 to 3600. Other
  /// values are an error of the update.
  vtkSetMacro(NumberOfAzimuths, int);
  vtkGetMacro(NumberOfAzimuths, int);
  ///@}

  ///@{
  /// Set/Get which arrays to add. By default all but EdgeTrust are on. If none is on, the update is
  /// an error.
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
  /// Set/Get how far the data must reach for EdgeTrust. With AutoEdgeDistance (the default) the
  /// distance is 1000 metres, or a tenth of the shorter side of the field if that is less.
  /// Otherwise it is EdgeDistance in metres, default 1000, 0 (any terrain at all) or more; other
  /// values are an error of the update.
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
