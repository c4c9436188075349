// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldShadowReceiver
 * @brief   computes how much of the sun each point of an object above the terrain sees
 *
 * Input 0 is any vtkPointSet (houses, aircraft, a point cloud) in the coordinates of the image,
 * with z in metres like the heights. Input 1 is the output of vtkHeightFieldShadowHeight. The
 * output is the point set with the float point array `SunVisibility`, from 0 (in the shadow of the
 * terrain) to 1. Shadows that the objects cast themselves are not included; put the objects on the
 * height field for that (vtkHeightFieldCap).
 *
 * If the image has the shadow heights of both limbs (Soft), SunVisibility is the lit part of the
 * disc, divided by horizontal chords; this is exact where one level edge shades the point.
 * Otherwise the shadow fades over PenumbraDepth (Lee & Kim, section 3.2). Between posts, shadow
 * heights are interpolated on the triangles of the terrain, with each cell split from post (i, j)
 * to post (i + 1, j + 1). Points outside the image, or in a triangle with a missing post, see the
 * sun as over level land without terrain.
 *
 * Each error is reported by one ErrorEvent with a text of one line. The output is then empty.
 */
#ifndef vtkHeightFieldShadowReceiver_h
#define vtkHeightFieldShadowReceiver_h

#include "SkylineFiltersModule.h"
#include "vtkPointSetAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithmOutput;
class vtkImageData;

class SKYLINEFILTERS_EXPORT vtkHeightFieldShadowReceiver : public vtkPointSetAlgorithm
{
public:
  static vtkHeightFieldShadowReceiver* New();
  vtkTypeMacro(vtkHeightFieldShadowReceiver, vtkPointSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Set the image with shadow heights: input 1.
  void SetShadowConnection(vtkAlgorithmOutput* shadow);
  void SetShadowData(vtkImageData* shadow);
  ///@}

  ///@{
  /// Set/Get the depth below the shadow height, in metres, over which the light fades. It is used
  /// if the image does not have the shadow heights of both limbs. The default is 0: a point is
  /// either lit or not. Values below 0 are clamped to 0.
  vtkSetClampMacro(PenumbraDepth, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PenumbraDepth, double);
  ///@}

protected:
  vtkHeightFieldShadowReceiver();
  ~vtkHeightFieldShadowReceiver() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int ComputeInputUpdateExtent(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

  double PenumbraDepth = 0.0;

private:
  vtkHeightFieldShadowReceiver(const vtkHeightFieldShadowReceiver&) = delete;
  void operator=(const vtkHeightFieldShadowReceiver&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
