// SPDX-License-Identifier: BSD-3-Clause
// Reference horizons of randomly chosen posts from the double-precision oracle, and errors against
// them.
#ifndef skyline_ReferenceHorizons_h
#define skyline_ReferenceHorizons_h

#include "Measure.h"
#include "Result.h"
#include "Scenes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// Horizons of some posts, each in all azimuths.
class ReferenceHorizons
{
public:
  /// `posts`: the number of posts. They are drawn at random, with `seed`, from those with four
  /// complete cells around them, because it is a matter of convention what a ray meets along the
  /// edge of the data. `azimuths`: degrees.
  ReferenceHorizons(const Scene& scene, std::ptrdiff_t posts, std::vector<double> azimuths,
    std::uint64_t seed, const WantsToStop& stop = {});

  /// The same for the given posts.
  ReferenceHorizons(const Scene& scene, std::vector<std::ptrdiff_t> posts,
    std::vector<double> azimuths, const WantsToStop& stop = {});

  std::vector<double> Azimuths;      ///< degrees clockwise from grid north
  std::vector<std::ptrdiff_t> Posts; ///< row * columns + column

  /// The elevation of the horizon in degrees, -90 if there is no terrain in that direction.
  double Elevation(std::size_t azimuth, std::size_t post) const
  {
    return this->Elevations[azimuth * this->Posts.size() + post];
  }

private:
  void Find(const oracle::OracleField& field, const WantsToStop& stop);

  std::vector<double> Elevations;
};

/// Collects differences and computes the errors.
class ErrorSum
{
public:
  void Add(double found, double right) { this->Differences.push_back(found - right); }
  Errors Get() const; ///< a difference that is not finite makes the errors not finite

private:
  std::vector<double> Differences;
};

} // namespace benchmark
} // namespace skyline

#endif
