// SPDX-License-Identifier: BSD-3-Clause
// Integrals of products of three spherical harmonics over the sphere (Gaunt coefficients of the
// real basis), computed at compile time or at run time.
//
// The azimuthal part has a closed form. The polar part is a polynomial of degree 21 or less, which
// a Gauss-Legendre rule with 12 nodes integrates exactly.
#ifndef skyline_HarmonicTensor_h
#define skyline_HarmonicTensor_h

#include "Harmonics/HarmonicRecurrence.h"
#include "Harmonics/SphericalHarmonics.h"
#include "Shared/Constants.h"
#include "Shared/GaussRule.h"

namespace skyline
{

constexpr int TensorNodes = 12; ///< 2 * 12 - 1 >= 3 * (MaxHarmonicBands - 1), and even

/// The nodes z > 0 of the rule, with the values of all Q_l^m at these nodes (see
/// HarmonicRecurrence.h).
struct PolarTable
{
  double Weight[TensorNodes / 2] = {}; ///< of a node and of its mirror image
  double Square[TensorNodes / 2] = {}; ///< 1 - z^2
  double Value[MaxHarmonicBands][MaxHarmonicBands][TensorNodes / 2] = {}; ///< [l][m][node]
};

constexpr PolarTable MakePolarTable()
{
  constexpr GaussRule<TensorNodes> rule;
  PolarTable table;
  for (int node = 0; node < TensorNodes / 2; ++node)
  {
    const double z = rule.Node[node];
    table.Square[node] = (1.0 - z) * (1.0 + z);
    table.Weight[node] = 2.0 * rule.Weight[node];
    for (int m = 0; m < MaxHarmonicBands; ++m)
    {
      double before = 0.0, value = HarmonicConstants.Start[m];
      table.Value[m][m][node] = value;
      for (int l = m + 1; l < MaxHarmonicBands; ++l)
      {
        const double next =
          HarmonicConstants.Rise[m][l] * z * value - HarmonicConstants.Before[m][l] * before;
        before = value;
        value = next;
        table.Value[l][m][node] = value;
      }
    }
  }
  return table;
}

inline constexpr PolarTable PolarNodes = MakePolarTable();

/// Integral over the full circle of the product of three factors: cos(m p) for m >= 0, sin(-m p)
/// for m < 0.
constexpr double AzimuthIntegral(int m1, int m2, int m3)
{
  const int sines = (m1 < 0) + (m2 < 0) + (m3 < 0);
  if (sines == 1 || sines == 3)
  {
    return 0.0;
  }
  // There are two sines or none; the remaining cosine goes last.
  const int last = m1 >= 0 ? m1 : m2 >= 0 ? m2 : m3;
  const int first = m1 >= 0 ? m2 : m1;
  const int second = m1 >= 0 || m2 >= 0 ? m3 : m2;
  const int a = first < 0 ? -first : first, b = second < 0 ? -second : second;
  const int differences = (a - b == last) + (b - a == last);
  const int sums = (a + b == last) + (a + b + last == 0);
  return 0.5 * Pi * (differences + (sines == 2 ? -sums : sums));
}

constexpr int HarmonicBand(int index)
{
  int l = 0;
  while ((l + 1) * (l + 1) <= index)
  {
    ++l;
  }
  return l;
}

/// Integral of Y_i Y_j Y_k over the sphere for indices below MaxHarmonicBands^2. It is exactly 0
/// where the selection rules say so.
constexpr double HarmonicTriple(int i, int j, int k)
{
  const int l1 = HarmonicBand(i), l2 = HarmonicBand(j), l3 = HarmonicBand(k);
  const int m1 = i - HarmonicIndex(l1, 0), m2 = j - HarmonicIndex(l2, 0);
  const int m3 = k - HarmonicIndex(l3, 0);
  const double turn = AzimuthIntegral(m1, m2, m3);
  if ((l1 + l2 + l3) % 2 != 0 || l1 + l2 < l3 || l2 + l3 < l1 || l3 + l1 < l2 || turn == 0.0)
  {
    return 0.0;
  }
  const int a = m1 < 0 ? -m1 : m1, b = m2 < 0 ? -m2 : m2, c = m3 < 0 ? -m3 : m3;
  double integral = 0.0;
  for (int node = 0; node < TensorNodes / 2; ++node)
  {
    double power = 1.0; // (1 - z^2)^((a + b + c) / 2); the sum is even if `turn` is not 0
    for (int p = 0; p < a + b + c; p += 2)
    {
      power *= PolarNodes.Square[node];
    }
    integral += PolarNodes.Weight[node] * power * PolarNodes.Value[l1][a][node] *
      PolarNodes.Value[l2][b][node] * PolarNodes.Value[l3][c][node];
  }
  // A few integrals vanish without a rule. The smallest one that does not is above 1e-3.
  return integral * turn > 1.0e-12 || integral * turn < -1.0e-12 ? integral * turn : 0.0;
}

} // namespace skyline

#endif
