// SPDX-License-Identifier: BSD-3-Clause
// How similar two pictures look.
#ifndef skyline_Similarity_h
#define skyline_Similarity_h

#include <cstddef>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// The mean structural similarity (SSIM; Wang, Bovik, Sheikh & Simoncelli 2004, equation 13, with
/// their constants) of two grey pictures of side x side values from 0 to 1. The windows of 8 x 8
/// pixels have equal weights and begin at every fourth pixel. 1 means identical. `side` must be 8
/// or more.
inline double StructuralSimilarity(
  const std::vector<double>& a, const std::vector<double>& b, std::ptrdiff_t side)
{
  constexpr std::ptrdiff_t window = 8, stride = 4;
  constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
  constexpr double count = window * window;
  double sum = 0.0;
  double windows = 0.0;
  for (std::ptrdiff_t j = 0; j + window <= side; j += stride)
  {
    for (std::ptrdiff_t i = 0; i + window <= side; i += stride)
    {
      double ma = 0.0, mb = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
      for (std::ptrdiff_t y = j; y < j + window; ++y)
      {
        for (std::ptrdiff_t x = i; x < i + window; ++x)
        {
          const double va = a[static_cast<std::size_t>(y * side + x)];
          const double vb = b[static_cast<std::size_t>(y * side + x)];
          ma += va / count;
          mb += vb / count;
          aa += va * va / count;
          bb += vb * vb / count;
          ab += va * vb / count;
        }
      }
      const double variances = aa - ma * ma + bb - mb * mb;
      sum += (2.0 * ma * mb + c1) * (2.0 * (ab - ma * mb) + c2) /
        ((ma * ma + mb * mb + c1) * (variances + c2));
      windows += 1.0;
    }
  }
  return sum / windows;
}

} // namespace benchmark
} // namespace skyline

#endif
