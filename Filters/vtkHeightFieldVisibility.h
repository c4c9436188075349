// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldVisibility
 * @brief   the sky that every post sees, as spherical harmonics
 *
 * Adds the float array `VisibilitySH`: the coefficients of the function that is 1 where the sky shows
 * above max(horizon, 0), bands^2 components (16 by default); real orthonormal harmonics without
 * Condon-Shortley phase, index l * l + l + m, x east, y north, z up. Projected in closed form, azimuth
 * by azimuth (Snyder & Nowrouzezahrai 2008, section 5, without their tables); no horizon is stored.
 *
 * A swath leaves all but a part of the azimuths out, for a light that stands in that part alone:
 * fewer horizons, sharper shadows.
 */
#ifndef vtkHeightFieldVisibility_h
#define vtkHeightFieldVisibility_h

#include "vtkHeightFieldAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <vector> // For azimuths

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkHeightFieldVisibility : public vtkHeightFieldAlgorithm
{
public:
  static vtkHeightFieldVisibility* New();
  vtkTypeMacro(vtkHeightFieldVisibility, vtkHeightFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Bands, the order of the harmonics; default 4, 2 to 8.
  vtkSetMacro(NumberOfBands, int);
  vtkGetMacro(NumberOfBands, int);
  ///@}

  ///@{
  /// Azimuths in the swath; default 32, 1 to 3600. SN08 take 16 to 32 around, 3 in a key light's.
  vtkSetMacro(NumberOfAzimuths, int);
  vtkGetMacro(NumberOfAzimuths, int);
  ///@}

  ///@{
  /// Middle of the swath, degrees clockwise from grid north, on a distorted map from the +y axis of the
  /// ground at every post; default 0. Without effect on a circle, whose first azimuth is north.
  vtkSetMacro(SwathAzimuth, double);
  vtkGetMacro(SwathAzimuth, double);
  ///@}

  ///@{
  /// Width of the swath, degrees, above 0 up to 360; default 360, the circle.
  vtkSetMacro(SwathWidth, double);
  vtkGetMacro(SwathWidth, double);
  ///@}

protected:
  vtkHeightFieldVisibility() = default;
  ~vtkHeightFieldVisibility() override = default;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

  /// Feeds the sky of all posts, times their cosine or not, to an array of the name.
  bool Project(
    skyline::HorizonDriver& driver, vtkImageData* output, const char* name, bool withCosine);

  /// Sums the sky over azimuths (degrees, each standing for `width` radians) into NumberOfBands^2
  /// values a post; east, north: the posts' gradients, or null for no cosine. False if stopped.
  virtual bool Sum(skyline::HorizonDriver& driver, const std::vector<double>& azimuths,
    double width, const float* east, const float* north, float* values);

  int NumberOfBands = 4;
  int NumberOfAzimuths = 32;
  double SwathAzimuth = 0.0;
  double SwathWidth = 360.0;

private:
  vtkHeightFieldVisibility(const vtkHeightFieldVisibility&) = delete;
  void operator=(const vtkHeightFieldVisibility&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
