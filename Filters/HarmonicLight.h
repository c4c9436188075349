// SPDX-License-Identifier: BSD-3-Clause
// Distant lights as spherical harmonics, and their product with the transfer of each post.
#ifndef skyline_HarmonicLight_h
#define skyline_HarmonicLight_h

#include "LightPasses.h"
#include "Sky/LightTable.h"
#include "SkylineFiltersModule.h" // for the export macro

#include <vector>

namespace skyline
{

/// The sum of several lights: bands^2 coefficients of red, then of green, then of blue.
class SKYLINEFILTERS_EXPORT HarmonicLight
{
public:
  /// bands: 1 to 8.
  explicit HarmonicLight(int bands);

  void Add(const TurnedLightMap& light);
  void Add(const SkyDisc& disc); ///< a point counts as a disc with a radius of 0.01 degrees

  /// Adds the light to the posts [begin, end): the dot products of their transfer (bands^2 floats
  /// each) with the coefficients. Negative products count as 0.
  void Light(const float* transfer, std::ptrdiff_t begin, std::ptrdiff_t end, float* rgb) const;

  const std::vector<double>& GetCoefficients() const { return this->Coefficients; }

private:
  int Bands;
  std::vector<double> Coefficients;
};

} // namespace skyline

#endif
