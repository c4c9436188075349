// SPDX-License-Identifier: BSD-3-Clause
// Constants of the spherical harmonics, computed at compile time.
//
// With Q_l^m = N_lm d^m P_l / dz^m (times sqrt(2) where m > 0) the functions are Q_l^m(z) times the
// real and imaginary parts of (x + i y)^m, and the three-term recurrence of the Legendre functions
// becomes
//   Q_l^m = a_lm z Q_(l-1)^m - (a_lm / a_(l-1)m) Q_(l-2)^m,   a_lm = sqrt((4 l^2 - 1) / (l^2 - m^2))
// from Q_m^m (a constant) and Q_(m-1)^m = 0.
#ifndef skyline_HarmonicRecurrence_h
#define skyline_HarmonicRecurrence_h

#include "Harmonics/SphericalHarmonics.h"
#include "Shared/Constants.h"

namespace skyline
{

/// Square root at compile time, by Newton's method from above. x must lie between 1e-3 and 1e3.
constexpr double ConstantRoot(double x)
{
  double root = x > 1.0 ? x : 1.0;
  for (int step = 0; step < 14; ++step)
  {
    root = 0.5 * (root + x / root);
  }
  return root;
}

struct HarmonicRecurrence
{
  double Start[MaxHarmonicBands] = {};                    ///< Q_m^m
  double Rise[MaxHarmonicBands][MaxHarmonicBands] = {};   ///< [m][l]: a_lm
  double Before[MaxHarmonicBands][MaxHarmonicBands] = {}; ///< [m][l]: a_lm / a_(l-1)m
  double ZenithInverse[MaxHarmonicBands] = {};            ///< 1 / Y_l,0(zenith)
};

constexpr HarmonicRecurrence MakeHarmonicRecurrence()
{
  HarmonicRecurrence table;
  for (int m = 0; m < MaxHarmonicBands; ++m)
  {
    // Q_m^m = sqrt((2 m + 1) / (4 pi) / (2 m)!) (2 m - 1)!!, and (2 m - 1)!!^2 / (2 m)! is the
    // product of (2 k - 1) / (2 k), k = 1 ... m.
    double square = (2.0 * m + 1.0) / (4.0 * Pi) * (m > 0 ? 2.0 : 1.0);
    for (int k = 1; k <= m; ++k)
    {
      square *= (2.0 * k - 1.0) / (2.0 * k);
    }
    table.Start[m] = ConstantRoot(square);
    table.ZenithInverse[m] = ConstantRoot(4.0 * Pi / (2.0 * m + 1.0));
    for (int l = m + 1; l < MaxHarmonicBands; ++l)
    {
      table.Rise[m][l] = ConstantRoot((4.0 * l * l - 1.0) / (l * l - m * m));
      table.Before[m][l] = l > m + 1 ? table.Rise[m][l] / table.Rise[m][l - 1] : 0.0;
    }
  }
  return table;
}

inline constexpr HarmonicRecurrence HarmonicConstants = MakeHarmonicRecurrence();

} // namespace skyline

#endif
