// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineLampLight
 * @brief   a glowing ball above, on or below the ground
 *
 * Terrain behind the lamp hides nothing of it. Unlike other lights, a lamp also shines from below
 * the horizontal plane. Values out of range are an error of the filter that uses the light.
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
  /// Set/Get the centre of the ball: x and y in the coordinates of the image of the height field
  /// (origin + spacing x post), z like the heights, in metres. The lamp may stand outside the
  /// image. The default is 0, 0, 0.
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  ///@}

  /// Set Position from x and y in the coordinate system of the raster (those of the image if there
  /// is no georeference), and from z like the heights, in metres.
  void SetMapPosition(vtkImageData* heightField, double x, double y, double z);

  ///@{
  /// Set/Get the radius in metres, 0 (no light) or more. The default is 10.
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /// Set/Get the radiance of the surface of the ball, the same in all directions: RGB, 0 or more.
  /// The default is 1, 1, 1.
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
