// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldShadowReceiver
 * @brief   which part of the sun the points of anything above the terrain see
 *
 * Inputs: 0, any vtkPointSet (houses, aircraft, a point cloud), its x and y in the frame of the image,
 * its z in metres like the heights; 1, the output of vtkHeightFieldShadowHeight. Output: the point set and the
 * point array `SunVisibility`, float, 0 (in the shadow of the terrain) to 1. What the points' own
 * surfaces shade is not known here: cap them onto the height field for that (vtkHeightFieldCap).
 *
 * With the heights of both limbs (Soft) it is the lit part of the disc by its chords, exact where one
 * level edge shades it; without, the shadow's edge is as deep as PenumbraDepth (Lee & Kim, section
 * 3.2). Shadow heights between posts are those of the triangles, each cell split from its (i, j) to
 * its (i + 1, j + 1) post, like the terrain's. Points outside the image, or in a triangle with a
 * missing post, see what a point over level land without terrain sees.
 *
 * Errors are reported by ErrorEvent in one line; the output then is empty.
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
  /// The image of shadow heights: input 1.
  void SetShadowConnection(vtkAlgorithmOutput* shadow);
  void SetShadowData(vtkImageData* shadow);
  ///@}

  ///@{
  /// Metres below the shadow height over which the light fades, where the image has no limbs; default
  /// 0: lit or not.
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
