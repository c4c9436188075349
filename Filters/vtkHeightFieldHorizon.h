// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldHorizon
 * @brief   the horizon all around every post
 *
 * Adds `HorizonElevation`: degrees above the horizontal plane, component k in azimuth 360 k / N
 * clockwise from grid north (the image's +y). The greatest elevation angle at which the azimuth's
 * vertical plane meets the surface beyond the post, to the edge of the data; it may be negative, and
 * is -90 where no terrain lies in the azimuth.
 */
#ifndef vtkHeightFieldHorizon_h
#define vtkHeightFieldHorizon_h

#include "vtkHeightFieldAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <vector> // For azimuths

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkHeightFieldHorizon : public vtkHeightFieldAlgorithm
{
public:
  static vtkHeightFieldHorizon* New();
  vtkTypeMacro(vtkHeightFieldHorizon, vtkHeightFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Azimuths around; default 36, 1 to 3600.
  vtkSetMacro(NumberOfAzimuths, int);
  vtkGetMacro(NumberOfAzimuths, int);
  ///@}

protected:
  vtkHeightFieldHorizon() = default;
  ~vtkHeightFieldHorizon() override = default;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

  /// Fills NumberOfAzimuths values a post, degrees. False if stopped.
  virtual bool Store(
    skyline::HorizonDriver& driver, const std::vector<double>& azimuths, float* values);

  int NumberOfAzimuths = 36;

private:
  vtkHeightFieldHorizon(const vtkHeightFieldHorizon&) = delete;
  void operator=(const vtkHeightFieldHorizon&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
