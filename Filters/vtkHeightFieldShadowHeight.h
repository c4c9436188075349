// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldShadowHeight
 * @brief   how high the shadow of the terrain stands over every post
 *
 * Adds `ShadowHeight`, metres in the frame of the heights: a point above the post is in the shadow of
 * the terrain if it lies lower (Lee & Kim). Where nothing shades the post it is the post's own height,
 * so that ShadowHeight less the heights is how deep the post lies in shadow, 0 where it is lit; it is
 * greater than the height in shadow alone.
 *
 * With Soft, adds the shadow heights of the two limbs of the disc, `ShadowHeightUpper` and
 * `ShadowHeightLower`: below the first (the lower of the two heights) the whole disc is hidden, above
 * the second nothing of it is. These are not cut off at the ground, since the ground may lie between
 * them: the lit part of a post needs both. vtkHeightFieldShadowReceiver makes light of them, at any height.
 *
 * All posts have one sun: with UseTime, that over the middle of the height field.
 *
 * The sun counts above the horizontal plane alone, as in vtkHeightFieldSunShadow: with the centre, or
 * the limb, on the plane or under it, its shadow height is plus infinity, so that every height compares
 * as lower; rasters hold no infinities, there it becomes nodata. For the centre a warning says so. With
 * the lower limb alone there, ShadowHeightLower is that of a light in the plane. Above 89.9 degrees a sun casts its shadow as from
 * there. The field data get `ShadowSun`: azimuth, elevation and angular radius, degrees.
 *
 * Method EXACT and FAST give the exact shadow of the triangles. SWEEP is Lee & Kim's recurrence as
 * published, in one pass: exact where rays pass from post to post (the axes), worn down elsewhere; it
 * knows no curvature, and runs once for each band of rows of one spacing. Neither PYRAMID nor the
 * surface BILINEAR has shadow heights.
 */
#ifndef vtkHeightFieldShadowHeight_h
#define vtkHeightFieldShadowHeight_h

#include "vtkHeightFieldSunAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <memory> // For MakeMethod

namespace skyline
{
class HorizonMethod;
}

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkHeightFieldShadowHeight : public vtkHeightFieldSunAlgorithm
{
public:
  static vtkHeightFieldShadowHeight* New();
  vtkTypeMacro(vtkHeightFieldShadowHeight, vtkHeightFieldSunAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Add the shadow heights of the two limbs of the disc; default off.
  vtkSetMacro(Soft, bool);
  vtkGetMacro(Soft, bool);
  vtkBooleanMacro(Soft, bool);
  ///@}

  ///@{
  /// Let ShadowHeight fall below the ground, where the shadow passes below; then it crosses the
  /// ground between posts where the shadow ends. Default off.
  vtkSetMacro(BelowTerrain, bool);
  vtkGetMacro(BelowTerrain, bool);
  vtkBooleanMacro(BelowTerrain, bool);
  ///@}

protected:
  vtkHeightFieldShadowHeight() = default;
  ~vtkHeightFieldShadowHeight() override = default;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

#ifndef __VTK_WRAP__
  /// What finds shadow heights of a light whose rays fall by `slope` metres a metre; a filter on another
  /// processor puts its own here.
  virtual std::unique_ptr<skyline::HorizonMethod> MakeMethod(
    skyline::HorizonDriver& driver, double slope);
#endif

  bool Soft = false;
  bool BelowTerrain = false;

private:
  vtkHeightFieldShadowHeight(const vtkHeightFieldShadowHeight&) = delete;
  void operator=(const vtkHeightFieldShadowHeight&) = delete;

  // The shadow heights of a light in the azimuth (degrees) of the elevation (radians); infinite unless
  // it has risen.
  bool AddShadow(skyline::HorizonDriver& driver, vtkImageData* output, const char* name,
    double azimuth, double elevation, bool risen, bool belowTerrain);
};
VTK_ABI_NAMESPACE_END

#endif
