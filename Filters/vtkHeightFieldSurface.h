// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHeightFieldSurface
 * @brief the triangles of a height field
 *
 * Input: one 2-D vtkImageData; heights are the point array chosen by SetInputArrayToProcess(0, ...)
 * (default: the active scalars). Output: the triangulation of the posts that Skyline's horizons are
 * exact on, each cell split from its south-west to its north-east post; cells with a missing post
 * (NaN, infinite) are left out, and posts that no cell uses. The point array Elevation holds the
 * heights before the exaggeration.
 *
 * With SkirtOn the output is the wall that hangs from the rims of that mesh instead, down to
 * SkirtBase: drawn beside it, the terrain looks like a block and not like a sheet.
 *
 * Where several processes ask for a piece each, the first gets all of it.
 */
#ifndef vtkHeightFieldSurface_h
#define vtkHeightFieldSurface_h

#include "SkylineFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkHeightFieldSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkHeightFieldSurface* New();
  vtkTypeMacro(vtkHeightFieldSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Every how many posts the mesh has a corner; the last row and column are always in. Default 1.
   */
  vtkSetClampMacro(Stride, int, 1, VTK_INT_MAX);
  vtkGetMacro(Stride, int);
  ///@}

  ///@{
  /**
   * Factor on the heights of the points. Default 1.
   */
  vtkSetMacro(Exaggeration, double);
  vtkGetMacro(Exaggeration, double);
  ///@}

  ///@{
  /**
   * The wall in place of the terrain, and the height at which it ends (after the exaggeration).
   * Defaults: off, 0.
   */
  vtkSetMacro(Skirt, bool);
  vtkGetMacro(Skirt, bool);
  vtkBooleanMacro(Skirt, bool);
  vtkSetMacro(SkirtBase, double);
  vtkGetMacro(SkirtBase, double);
  ///@}

protected:
  vtkHeightFieldSurface();
  ~vtkHeightFieldSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  int Stride = 1;
  double Exaggeration = 1.0;
  bool Skirt = false;
  double SkirtBase = 0.0;

  vtkHeightFieldSurface(const vtkHeightFieldSurface&) = delete;
  void operator=(const vtkHeightFieldSurface&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
