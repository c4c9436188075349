// SPDX-License-Identifier: BSD-3-Clause
// A random sample of horizons by the double-precision oracle, and errors against it.
#ifndef skyline_Truth_h
#define skyline_Truth_h

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
class Truth
{
public:
  /// posts: how many, drawn with the seed from those with four complete cells around them: along
  /// the very edge of the data it is a matter of convention what a ray meets. azimuths: degrees.
  Truth(const Scene& scene, std::ptrdiff_t posts, std::vector<double> azimuths, std::uint64_t seed,
    const WantsToStop& stop = {});

  /// The same for given posts.
  Truth(const Scene& scene, std::vector<std::ptrdiff_t> posts, std::vector<double> azimuths,
    const WantsToStop& stop = {});

  std::vector<double> Azimuths;      ///< degrees clockwise from grid north
  std::vector<std::ptrdiff_t> Posts; ///< row * columns + column

  /// Degrees of elevation, -90 where no terrain lies.
  double Elevation(std::size_t azimuth, std::size_t post) const
  {
    return this->Elevations[azimuth * this->Posts.size() + post];
  }

private:
  void Find(const oracle::OracleField& field, const WantsToStop& stop);

  std::vector<double> Elevations;
};

/// Collects differences of elevations.
class ErrorSum
{
public:
  void Add(double found, double right) { this->Differences.push_back(found - right); }
  Errors Get() const; ///< not finite differences make not finite errors

private:
  std::vector<double> Differences;
};

} // namespace benchmark
} // namespace skyline

#endif
