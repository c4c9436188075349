// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHeightFieldSurface
 * @brief makes the triangle mesh of a height field
 *
 * The input is a 2-D vtkImageData. Its heights are the point array chosen by
 * SetInputArrayToProcess(0, ...), by default the active scalars. The output is the triangle mesh
 * for which the horizons of Skyline are exact: each cell is split from its south-west to its
 * north-east post. Cells with a missing post (NaN or infinite) are left out, and so are posts that
 * no cell uses. The point array Elevation holds the heights before the exaggeration.
 *
 * With SkirtOn, the output is a wall instead, from the edges of that mesh down to SkirtBase. Drawn
 * together with the mesh, it makes the terrain look like a solid block.
 *
 * If several processes each ask for a piece, the first one gets the whole output.
 */
#ifndef vtkHeightFieldSurface_h
#define vtkHeightFieldSurface_h

#include "SkylineFiltersModule.h" // for the export macro
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
   * Set/Get the number of posts from one mesh point to the next. The last row and the last column
   * are always included. The default is 1.
   */
  vtkSetClampMacro(Stride, int, 1, VTK_INT_MAX);
  vtkGetMacro(Stride, int);
  ///@}

  ///@{
  /**
   * Set/Get the factor by which the heights of the points are multiplied. The default is 1.
   */
  vtkSetMacro(Exaggeration, double);
  vtkGetMacro(Exaggeration, double);
  ///@}

  ///@{
  /**
   * Set/Get whether the wall is made instead of the terrain (default off), and the height of its
   * lower edge, after the exaggeration (default 0).
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
