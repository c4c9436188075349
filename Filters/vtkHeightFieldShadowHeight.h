// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldShadowHeight
 * @brief   computes how high the shadow of the terrain reaches above each post
 *
 * Adds the float array `ShadowHeight`, in metres, in the same frame as the heights: a point above
 * the post lies in the shadow of the terrain if it is lower than this (Lee & Kim). Where nothing
 * shades the post, ShadowHeight is the height of the post. Thus ShadowHeight minus the heights is
 * the depth of the post in shadow; it is 0 where the post is lit.
 *
 * With Soft, adds two more arrays, one for each limb of the sun's disc: `ShadowHeightUpper` and
 * `ShadowHeightLower`. Below the first, which is the lower one, the whole disc is hidden; above the
 * second nothing of the disc is hidden. These heights may lie below the ground, since the ground
 * may lie between them, and the lit part of a post needs both. vtkHeightFieldShadowReceiver
 * computes the light at any height from them.
 *
 * All posts have the same sun; with UseTime it is the sun over the middle of the height field.
 *
 * The sun counts only above the horizontal plane, as in vtkHeightFieldSunShadow. If the centre of
 * the sun, or a limb, stands on the plane or below it, its shadow height is plus infinity, so that
 * every height is lower. (Rasters cannot hold infinities; there it becomes nodata.) For the centre,
 * a warning is reported. If only the lower limb is not above the plane, ShadowHeightLower is that
 * of a light in the plane. A sun above 89.9 degrees is treated as one at 89.9 degrees. The field
 * data get the array `ShadowSun`: azimuth, elevation and angular radius of the sun in degrees.
 *
 * Methods EXACT and FAST give the exact shadow of the triangles. SWEEP is the recurrence that Lee &
 * Kim published, in one pass: it is exact where rays pass from post to post (along the axes), and
 * shadows become too short elsewhere. It has no curvature, and it runs separately for each band of
 * rows with one spacing. Method PYRAMID and surface BILINEAR are errors of the update.
 */
#ifndef vtkHeightFieldShadowHeight_h
#define vtkHeightFieldShadowHeight_h

#include "vtkHeightFieldSunAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <memory> // for MakeMethod

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
  /// Set/Get whether the shadow heights of the two limbs of the disc are added. The default is off.
  vtkSetMacro(Soft, bool);
  vtkGetMacro(Soft, bool);
  vtkBooleanMacro(Soft, bool);
  ///@}

  ///@{
  /// Set/Get whether ShadowHeight may lie below the ground where the shadow passes below. It then
  /// crosses the ground between posts where the shadow ends. The default is off.
  vtkSetMacro(BelowTerrain, bool);
  vtkGetMacro(BelowTerrain, bool);
  vtkBooleanMacro(BelowTerrain, bool);
  ///@}

protected:
  vtkHeightFieldShadowHeight() = default;
  ~vtkHeightFieldShadowHeight() override = default;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

#ifndef __VTK_WRAP__
  /// Makes the method that finds shadow heights of a light whose rays fall by `slope` metres per
  /// metre. A filter that uses another processor overrides this.
  virtual std::unique_ptr<skyline::HorizonMethod> MakeMethod(
    skyline::HorizonDriver& driver, double slope);
#endif

  bool Soft = false;
  bool BelowTerrain = false;

private:
  vtkHeightFieldShadowHeight(const vtkHeightFieldShadowHeight&) = delete;
  void operator=(const vtkHeightFieldShadowHeight&) = delete;

  // Adds the shadow heights of a light at `azimuth` (degrees) and `elevation` (radians). They are
  // infinite if the light is not above the horizontal plane.
  bool AddShadow(skyline::HorizonDriver& driver, vtkImageData* output, const char* name,
    double azimuth, double elevation, bool risen, bool belowTerrain);
};
VTK_ABI_NAMESPACE_END

#endif
