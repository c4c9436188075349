// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldVisibility
 * @brief   computes the visible sky of each post as spherical harmonics
 *
 * Adds the float array `VisibilitySH` with bands^2 components (16 by default): the coefficients of
 * the function that is 1 above max(horizon, 0) and 0 elsewhere. The harmonics are real and
 * orthonormal, without the Condon-Shortley phase; function (l, m) has the index l * l + l + m; x
 * points east, y north and z up. The projection is in closed form for each azimuth (Snyder &
 * Nowrouzezahrai 2008, section 5, without their tables). No horizon is stored.
 *
 * With SwathWidth below 360, only a part of the azimuths is used, for a light that stands in that
 * part: this needs fewer horizons and gives sharper shadows.
 */
#ifndef vtkHeightFieldVisibility_h
#define vtkHeightFieldVisibility_h

#include "vtkHeightFieldAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <vector> // for azimuths

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkHeightFieldVisibility : public vtkHeightFieldAlgorithm
{
public:
  static vtkHeightFieldVisibility* New();
  vtkTypeMacro(vtkHeightFieldVisibility, vtkHeightFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Set/Get the number of bands. The default is 4, the range 2 to 8. Other values are an error of
  /// the update.
  vtkSetMacro(NumberOfBands, int);
  vtkGetMacro(NumberOfBands, int);
  ///@}

  ///@{
  /// Set/Get the number of azimuths in the swath. The default is 32, the range 1 to 3600. Other
  /// values are an error of the update. Snyder & Nowrouzezahrai use 16 to 32 for the full circle
  /// and 3 for a key light.
  vtkSetMacro(NumberOfAzimuths, int);
  vtkGetMacro(NumberOfAzimuths, int);
  ///@}

  ///@{
  /// Set/Get the middle of the swath in degrees clockwise from grid north (on a distorted map, from
  /// the direction on the ground of the +y axis at each post). The default is 0. It has no effect
  /// on the full circle, whose first azimuth is north.
  vtkSetMacro(SwathAzimuth, double);
  vtkGetMacro(SwathAzimuth, double);
  ///@}

  ///@{
  /// Set/Get the width of the swath in degrees, above 0 and at most 360. The default is 360, the
  /// full circle. Other values are an error of the update.
  vtkSetMacro(SwathWidth, double);
  vtkGetMacro(SwathWidth, double);
  ///@}

protected:
  vtkHeightFieldVisibility() = default;
  ~vtkHeightFieldVisibility() override = default;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

  /// Adds the array `name` with the projected visibility of all posts, or with their transfer if
  /// `withCosine`. Returns false if aborted.
  bool Project(
    skyline::HorizonDriver& driver, vtkImageData* output, const char* name, bool withCosine);

  /// Adds up the visible sky over azimuths (radians, each standing for `width` radians) into
  /// NumberOfBands^2 values per post. `east` and `north` are the gradients of the posts, or null
  /// for no cosine. Returns false if aborted.
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
