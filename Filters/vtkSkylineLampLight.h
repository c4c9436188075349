// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineLampLight
 * @brief   a glowing ball over, on or under the ground
 *
 * Terrain behind it hides nothing. It shines wherever it is, below the horizontal plane too.
 */
#ifndef vtkSkylineLampLight_h
#define vtkSkylineLampLight_h

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSkylineLight.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

class SKYLINEFILTERS_EXPORT vtkSkylineLampLight : public vtkSkylineLight
{
public:
  static vtkSkylineLampLight* New();
  vtkTypeMacro(vtkSkylineLampLight, vtkSkylineLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// x and y in the coordinates of the height field's image (origin + spacing x post; the lamp may
  /// stand beside it), z as its heights, metres. Default 0, 0, 0.
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  ///@}

  /// Sets Position from x and y in the coordinate system of the height field's raster (in the image's
  /// where it has none) and z as its heights, metres.
  void SetMapPosition(vtkImageData* heightField, double x, double y, double z);

  ///@{
  /// Metres, 0 (no light) or more; default 10.
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /// RGB, 0 or more, of every point of it to every side; default 1, 1, 1.
  vtkSetVector3Macro(Radiance, double);
  vtkGetVector3Macro(Radiance, double);
  ///@}

protected:
  vtkSkylineLampLight() = default;
  ~vtkSkylineLampLight() override = default;

  double Position[3] = { 0.0, 0.0, 0.0 };
  double Radius = 10.0;
  double Radiance[3] = { 1.0, 1.0, 1.0 };

private:
  vtkSkylineLampLight(const vtkSkylineLampLight&) = delete;
  void operator=(const vtkSkylineLampLight&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
