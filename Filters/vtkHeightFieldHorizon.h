// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldHorizon
 * @brief   computes the horizon around each post
 *
 * Adds the float array `HorizonElevation` with N = NumberOfAzimuths components: the elevation angle
 * of the horizon in degrees above the horizontal plane. Component k is the horizon in the azimuth
 * 360 k / N degrees, clockwise from grid north (the +y axis of the image). The horizon is the
 * greatest elevation angle at which the vertical plane of the azimuth meets the surface, from the
 * post to the edge of the data. It may be negative, and it is -90 where no terrain lies in the
 * azimuth.
 */
#ifndef vtkHeightFieldHorizon_h
#define vtkHeightFieldHorizon_h

#include "vtkHeightFieldAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <vector> // for azimuths

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkHeightFieldHorizon : public vtkHeightFieldAlgorithm
{
public:
  static vtkHeightFieldHorizon* New();
  vtkTypeMacro(vtkHeightFieldHorizon, vtkHeightFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Set/Get the number of evenly spaced azimuths. The default is 36, the range 1 to 3600. Other
  /// values are an error of the update.
  vtkSetMacro(NumberOfAzimuths, int);
  vtkGetMacro(NumberOfAzimuths, int);
  ///@}

protected:
  vtkHeightFieldHorizon() = default;
  ~vtkHeightFieldHorizon() override = default;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

  /// Fills `values` with NumberOfAzimuths values per post, in degrees; `azimuths` are in radians.
  /// Returns false if aborted.
  virtual bool Store(
    skyline::HorizonDriver& driver, const std::vector<double>& azimuths, float* values);

  int NumberOfAzimuths = 36;

private:
  vtkHeightFieldHorizon(const vtkHeightFieldHorizon&) = delete;
  void operator=(const vtkHeightFieldHorizon&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
