// SPDX-License-Identifier: BSD-3-Clause
#include "Harmonics/SphericalHarmonics.h"

#include "Harmonics/HarmonicRecurrence.h"
#include "Shared/Constants.h"

#include <cmath>

namespace skyline
{

namespace
{

/// sqrt((2 l + 1) / (4 pi)): the value of Y_l,0 at the zenith.
double ZenithValue(int l)
{
  return std::sqrt((2.0 * l + 1.0) / (4.0 * Pi));
}

} // namespace

template <typename Real>
void EvaluateHarmonics(int bands, Real x, Real y, Real z, Real* values)
{
  Real even = 1, odd = 0; // real and imaginary part of (x + i y)^m
  for (int m = 0; m < bands; ++m)
  {
    Real before = 0;
    Real value = static_cast<Real>(HarmonicConstants.Start[m]);
    for (int l = m;;)
    {
      values[HarmonicIndex(l, -m)] = value * odd;
      values[HarmonicIndex(l, m)] = value * even; // set last: for m = 0 there is one function
      if (++l == bands)
      {
        break;
      }
      const Real next = static_cast<Real>(HarmonicConstants.Rise[m][l]) * z * value -
        static_cast<Real>(HarmonicConstants.Before[m][l]) * before;
      before = value;
      value = next;
    }
    const Real turned = even * x - odd * y;
    odd = even * y + odd * x;
    even = turned;
  }
}

template <typename Real>
void RotateAboutVertical(int bands, double angleClockwise, const Real* in, Real* out)
{
  for (int m = 0; m < bands; ++m)
  {
    const Real cosine = static_cast<Real>(std::cos(m * angleClockwise));
    const Real sine = static_cast<Real>(std::sin(m * angleClockwise));
    for (int l = m; l < bands; ++l)
    {
      const Real even = in[HarmonicIndex(l, m)], odd = in[HarmonicIndex(l, -m)];
      out[HarmonicIndex(l, -m)] = cosine * odd - sine * even;
      out[HarmonicIndex(l, m)] = cosine * even + sine * odd; // for m = 0 the same element,
                                                             // unchanged
    }
  }
}

template <typename Real>
void RotateZonal(int bands, const Real* zonal, Real x, Real y, Real z, Real* out)
{
  EvaluateHarmonics(bands, x, y, z, out);
  for (int l = 0; l < bands; ++l)
  {
    const Real weight = static_cast<Real>(HarmonicConstants.ZenithInverse[l]) * zonal[l];
    for (int k = HarmonicIndex(l, -l); k <= HarmonicIndex(l, l); ++k)
    {
      out[k] *= weight;
    }
  }
}

// Integral over 0 ... 1 of t P_l(t), Ramamoorthi & Hanrahan 2001, equation 8, from the generating
// function: 1/2, 1/3, then 0 for odd l and (-1)^(l/2 - 1) / ((l + 2) (l - 1)) * l! / (2^l
// (l/2)!^2).
double ClampedCosineZonal(int l)
{
  double integral = l == 1 ? 1.0 / 3.0 : 0.0;
  if (l % 2 == 0)
  {
    integral = -1.0 / ((l + 2.0) * (l - 1.0));
    for (int k = 1; k <= l / 2; ++k)
    {
      integral *= -(2.0 * k - 1.0) / (2.0 * k);
    }
  }
  return 2.0 * Pi * ZenithValue(l) * integral;
}

double HemisphereZonal(int l)
{
  return CapZonal(l, 0.0);
}

// Integral over c ... 1 of P_l(t) = (1 - c^2) P_l'(c) / (l (l + 1)), by Legendre's equation. It is
// accurate for small caps, where (P_(l-1)(c) - P_(l+1)(c)) / (2 l + 1) would lose digits.
double CapZonal(int l, double cosRadius)
{
  const double c = cosRadius;
  double integral = 1.0 - c;
  if (l > 0)
  {
    double before = 0.0, slope = 1.0; // P_0', P_1'
    for (int k = 1; k < l; ++k)
    {
      const double next = ((2.0 * k + 1.0) * c * slope - (k + 1.0) * before) / k;
      before = slope;
      slope = next;
    }
    integral = (1.0 - c) * (1.0 + c) * slope / (l * (l + 1.0));
  }
  return 2.0 * Pi * ZenithValue(l) * integral;
}

template void EvaluateHarmonics(int, float, float, float, float*);
template void EvaluateHarmonics(int, double, double, double, double*);
template void RotateAboutVertical(int, double, const float*, float*);
template void RotateAboutVertical(int, double, const double*, double*);
template void RotateZonal(int, const float*, float, float, float, float*);
template void RotateZonal(int, const double*, double, double, double, double*);

} // namespace skyline
