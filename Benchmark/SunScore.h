// SPDX-License-Identifier: BSD-3-Clause
// Compares the light of point suns with the reference, in the window of a scene.
#ifndef skyline_SunScore_h
#define skyline_SunScore_h

#include "ReferenceScene.h"
#include "Result.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// The result of a method at a post (of the whole scene, row by row from the south).
using SunOf = std::function<double(std::size_t post)>;

/// Collects the results for one sun after the other. The edges of the data have no reference and
/// are left out.
class SunScore
{
public:
  enum class Kind
  {
    Lit, ///< above 0 means lit. Counts posts on the wrong side
    Beam ///< the cosine of incidence, 0 in shadow. Errors in % of the mean
  };

  SunScore(ReferenceScene& reference, Kind kind);

  void Add(std::size_t sun, const SunOf& found);

  /// Fills in the errors, the wrong posts and the similarity of the shaded pictures.
  void Report(Result& result) const;

private:
  double Incidence(std::ptrdiff_t post, const SunAt& sun) const; // cosine of the angle, at least 0

  const oracle::OracleField& Field;
  const ReferenceHorizons& Right;
  std::ptrdiff_t Side;
  Kind What;
  std::vector<double> FoundBeams, RightBeams;
  double Wrong = 0.0, Posts = 0.0, Similarities = 0.0;
};

} // namespace benchmark
} // namespace skyline

#endif
