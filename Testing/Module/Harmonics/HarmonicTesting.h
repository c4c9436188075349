// SPDX-License-Identifier: BSD-3-Clause
// Tolerances and random vectors for the tests of harmonics.
#ifndef skyline_HarmonicTesting_h
#define skyline_HarmonicTesting_h

#include <algorithm>
#include <random>
#include <vector>

namespace skyline
{
namespace testing
{

/// The tolerance for sums of harmonics in double precision, with up to a few hundred terms near 1.
constexpr double AlgebraBound = 1.0e-12;

/// Random numbers in [-1, 1].
inline std::vector<double> RandomVector(int count, unsigned seed)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<double> vector(count);
  std::generate(vector.begin(), vector.end(), [&] { return uniform(engine); });
  return vector;
}

} // namespace testing
} // namespace skyline

#endif
