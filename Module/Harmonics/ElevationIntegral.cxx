// SPDX-License-Identifier: BSD-3-Clause
#include "Harmonics/ElevationIntegral.h"

#include "Shared/Constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace skyline
{

namespace
{

using Polynomial = std::vector<double>; // coefficients of rising powers

Polynomial Times(const Polynomial& a, const Polynomial& b)
{
  Polynomial product(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      product[i + j] += a[i] * b[j];
    }
  }
  return product;
}

/// (1 - q)^power in powers of q.
Polynomial OneMinus(int power)
{
  Polynomial result{ 1.0 };
  for (int k = 0; k < power; ++k)
  {
    result = Times(result, { 1.0, -1.0 });
  }
  return result;
}

/// P_l in powers of its argument: (k + 1) P_k+1 = (2 k + 1) z P_k - k P_k-1.
Polynomial Legendre(int l)
{
  Polynomial before{ 0.0 };
  Polynomial now{ 1.0 };
  for (int k = 0; k < l; ++k)
  {
    Polynomial next = Times(now, { 0.0, 2.0 * k + 1.0 });
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      next[i] -= k * before[i];
    }
    for (double& coefficient : next)
    {
      coefficient /= k + 1.0;
    }
    before = now;
    now = next;
  }
  return now;
}

/// N_lm Q: the harmonic is cos^m e times this polynomial.
Polynomial HarmonicPolynomial(int l, int m)
{
  Polynomial q = Legendre(l);
  double norm = (2.0 * l + 1.0) / (4.0 * Pi) * (m > 0 ? 2.0 : 1.0);
  for (int k = 0; k < m; ++k)
  {
    for (std::size_t i = 1; i < q.size(); ++i)
    {
      q[i - 1] = static_cast<double>(i) * q[i];
    }
    q.pop_back();
    norm /= (l - k) * (l + k + 1.0); // (l - m)! / (l + m)!, factor by factor
  }
  for (double& coefficient : q)
  {
    coefficient *= std::sqrt(norm);
  }
  return q;
}

/// The coefficients of every other power, starting at `first`, as a polynomial in q.
Polynomial EveryOther(const Polynomial& p, std::size_t first)
{
  Polynomial result;
  for (std::size_t i = first; i < p.size(); i += 2)
  {
    result.push_back(p[i]);
  }
  return result;
}

// Int_0^s (1 - t^2)^((n - 1) / 2) r(t^2) t^odd dt. The result p is multiplied by s (odd = 0) or q
// (odd = 1).
Polynomial OddCosine(int n, const Polynomial& r, int odd)
{
  Polynomial p = Times(OneMinus((n - 1) / 2), r);
  for (std::size_t k = 0; k < p.size(); ++k)
  {
    p[k] /= 2.0 * static_cast<double>(k) + 1.0 + odd;
  }
  return p;
}

// Int_0^h cos^n e r(sin^2 e) sin e de = Int_c^1 u^n r(1 - u^2) du = A + c p(q).
Polynomial EvenCosineOddSine(int n, const Polynomial& r, double& constant)
{
  // r(1 - u^2) in powers of u^2.
  Polynomial inCosine{ 0.0 };
  for (std::size_t k = 0; k < r.size(); ++k)
  {
    const Polynomial power = OneMinus(static_cast<int>(k));
    inCosine.resize(std::max(inCosine.size(), power.size()), 0.0);
    for (std::size_t i = 0; i < power.size(); ++i)
    {
      inCosine[i] += r[k] * power[i];
    }
  }
  constant = 0.0;
  Polynomial p{ 0.0 };
  for (std::size_t k = 0; k < inCosine.size(); ++k)
  {
    const double part = inCosine[k] / (n + 1.0 + 2.0 * static_cast<double>(k));
    constant += part;
    const Polynomial power = OneMinus(n / 2 + static_cast<int>(k)); // c^(n + 2 k)
    p.resize(std::max(p.size(), power.size()), 0.0);
    for (std::size_t i = 0; i < power.size(); ++i)
    {
      p[i] -= part * power[i];
    }
  }
  return p;
}

// Int_0^h cos^n e r(sin^2 e) de = A h + s c p(q), by
// J_k = Int_0^h sin^2k e de = ((2 k - 1) J_k-1 - s^(2 k - 1) c) / 2 k, J_0 = h.
Polynomial EvenCosineEvenSine(int n, const Polynomial& r, double& constant)
{
  const Polynomial powers = Times(OneMinus(n / 2), r);
  constant = 0.0;
  Polynomial p(std::max<std::size_t>(powers.size() - 1, 1), 0.0);
  double angle = 1.0; // J_k = angle h + s c j(q)
  Polynomial j;
  for (std::size_t k = 0; k < powers.size(); ++k)
  {
    if (k > 0)
    {
      const double twice = 2.0 * static_cast<double>(k);
      const double factor = (twice - 1.0) / twice;
      angle *= factor;
      for (double& coefficient : j)
      {
        coefficient *= factor;
      }
      j.push_back(-1.0 / twice);
    }
    constant += powers[k] * angle;
    for (std::size_t i = 0; i < j.size(); ++i)
    {
      p[i] += powers[k] * j[i];
    }
  }
  return p;
}

} // namespace

double ElevationIntegral::Lost(double horizon) const
{
  const double s = std::sin(horizon);
  const double c = std::cos(horizon);
  double p = 0.0;
  for (int k = this->Terms - 1; k >= 0; --k)
  {
    p = p * s * s + this->Polynomial[static_cast<std::size_t>(k)];
  }
  switch (this->Kind)
  {
    case ElevationKind::Sine:
      return s * p;
    case ElevationKind::Square:
      return s * s * p;
    case ElevationKind::SineCosine:
      return this->Constant * horizon + s * c * p;
    case ElevationKind::Cosine:
      break;
  }
  return this->Constant + c * p;
}

ElevationIntegral MakeElevationIntegral(int l, int m, ElevationWeight weight)
{
  // cos^m from the harmonic, and one cosine from the solid angle.
  const int n = m + 1 + (weight == ElevationWeight::Forward ? 1 : 0);
  Polynomial q = HarmonicPolynomial(l, m);
  int parity = (l - m) % 2;
  if (weight == ElevationWeight::Upward)
  {
    q.insert(q.begin(), 0.0);
    parity = 1 - parity;
  }
  const Polynomial r = EveryOther(q, static_cast<std::size_t>(parity));
  ElevationIntegral integral;
  Polynomial p;
  if (n % 2 == 1)
  {
    integral.Kind = parity == 0 ? ElevationKind::Sine : ElevationKind::Square;
    p = OddCosine(n, r, parity);
  }
  else if (parity == 1)
  {
    integral.Kind = ElevationKind::Cosine;
    p = EvenCosineOddSine(n, r, integral.Constant);
  }
  else
  {
    integral.Kind = ElevationKind::SineCosine;
    p = EvenCosineEvenSine(n, r, integral.Constant);
  }
  integral.Terms = static_cast<int>(p.size());
  for (std::size_t k = 0; k < p.size(); ++k)
  {
    integral.Polynomial.at(k) = p[k];
  }
  integral.Whole = integral.Lost(0.5 * Pi);
  return integral;
}

std::vector<ElevationIntegral> ElevationIntegrals(int bands, ElevationWeight weight)
{
  std::vector<ElevationIntegral> integrals;
  for (int m = 0; m < bands; ++m)
  {
    for (int l = m; l < bands; ++l)
    {
      integrals.push_back(MakeElevationIntegral(l, m, weight));
    }
  }
  return integrals;
}

} // namespace skyline
