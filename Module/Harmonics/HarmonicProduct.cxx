// SPDX-License-Identifier: BSD-3-Clause
#include "Harmonics/HarmonicProduct.h"

#include "Harmonics/HarmonicTensor.h"
#include "Harmonics/SphericalHarmonics.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace skyline
{

namespace
{

constexpr int UnrolledBands = DefaultHarmonicBands;
constexpr int UnrolledCount = HarmonicCount(UnrolledBands);

/// Calls visit(i, j, k, value) for each term of a tensor.
template <typename Visit>
constexpr void VisitTerms(int bands, const Visit& visit)
{
  for (int i = 0; i < HarmonicCount(bands); ++i)
  {
    for (int j = i; j < HarmonicCount(bands); ++j)
    {
      for (int k = j; k < HarmonicCount(bands); ++k)
      {
        const double value = HarmonicTriple(i, j, k);
        if (value != 0.0)
        {
          visit(i, j, k, value);
        }
      }
    }
  }
}

constexpr std::size_t CountTerms(int bands)
{
  std::size_t count = 0;
  VisitTerms(bands, [&count](int, int, int, double) { ++count; });
  return count;
}

constexpr std::size_t UnrolledSize = CountTerms(UnrolledBands);

struct UnrolledTensor
{
  HarmonicTerm Term[UnrolledSize] = {};
};

constexpr UnrolledTensor MakeUnrolled()
{
  UnrolledTensor tensor;
  std::size_t count = 0;
  VisitTerms(UnrolledBands,
    [&](int i, int j, int k, double value)
    {
      tensor.Term[count].I = i;
      tensor.Term[count].J = j;
      tensor.Term[count].K = k;
      tensor.Term[count].Value = value;
      ++count;
    });
  return tensor;
}

constexpr UnrolledTensor Unrolled = MakeUnrolled();

/// Adds a term to the product, for all permutations of its indices. It is always inlined, because
/// the speed depends on constant indices.
template <typename Real>
[[gnu::always_inline]] inline void AddTerm(
  int i, int j, int k, Real value, const Real* a, const Real* b, Real* out)
{
  if (i == j && j == k)
  {
    out[i] += value * (a[i] * b[i]);
  }
  else if (i == j)
  {
    out[k] += value * (a[i] * b[i]);
    out[i] += value * (a[i] * b[k] + a[k] * b[i]);
  }
  else if (j == k)
  {
    out[i] += value * (a[j] * b[j]);
    out[j] += value * (a[i] * b[j] + a[j] * b[i]);
  }
  else
  {
    out[i] += value * (a[j] * b[k] + a[k] * b[j]);
    out[j] += value * (a[i] * b[k] + a[k] * b[i]);
    out[k] += value * (a[i] * b[j] + a[j] * b[i]);
  }
}

/// The loop over all terms with indices known at compile time: no indices are loaded, and the sums
/// stay in registers.
template <typename Real, std::size_t... Term>
inline void UnrolledProduct(const Real* a, const Real* b, Real* out, std::index_sequence<Term...>)
{
  Real sum[UnrolledCount] = {};
  (AddTerm(Unrolled.Term[Term].I, Unrolled.Term[Term].J, Unrolled.Term[Term].K,
     static_cast<Real>(Unrolled.Term[Term].Value), a, b, sum),
    ...);
  for (int k = 0; k < UnrolledCount; ++k)
  {
    out[k] = sum[k];
  }
}

} // namespace

HarmonicProduct::HarmonicProduct(int bands)
  : NumberOfBands(bands)
{
  VisitTerms(bands,
    [this](int i, int j, int k, double value) {
      this->Tensor.push_back({ i, j, k, value });
    });

  const int count = HarmonicCount(bands);
  for (int i = 0; i < count; ++i)
  {
    for (int j = i; j < count; ++j)
    {
      const auto begin = static_cast<int>(this->Doubles.size());
      for (int k = 0; k < count; ++k)
      {
        const double weight = HarmonicTriple(i, j, k) * (i == j ? 0.5 : 1.0);
        if (weight != 0.0)
        {
          this->Doubles.push_back({ k, weight });
          this->Floats.push_back({ k, static_cast<float>(weight) });
        }
      }
      const auto end = static_cast<int>(this->Doubles.size());
      if (begin < end)
      {
        this->Pairs.push_back({ i, j, begin, end });
      }
    }
  }
}

template <int Bands>
const HarmonicProduct& HarmonicProduct::Built()
{
  static const HarmonicProduct product(Bands);
  return product;
}

const HarmonicProduct& HarmonicProduct::ForBands(int bands)
{
  switch (bands)
  {
    case 2:
      return Built<2>();
    case 3:
      return Built<3>();
    case 4:
      return Built<4>();
    case 5:
      return Built<5>();
    case 6:
      return Built<6>();
    case 7:
      return Built<7>();
    case 8:
      return Built<8>();
    default:
      throw std::invalid_argument(
        std::to_string(bands) + " bands of spherical harmonics; give 2 to 8");
  }
}

template <typename Real>
auto HarmonicProduct::Entries() const -> const std::vector<Entry<Real>>&
{
  if constexpr (std::is_same_v<Real, float>)
  {
    return this->Floats;
  }
  else
  {
    return this->Doubles;
  }
}

template <typename Real>
void HarmonicProduct::Product(const Real* a, const Real* b, Real* out) const
{
  if (this->NumberOfBands == UnrolledBands)
  {
    UnrolledProduct(a, b, out, std::make_index_sequence<UnrolledSize>());
    return;
  }
  std::fill_n(out, HarmonicCount(this->NumberOfBands), Real(0));
  const Entry<Real>* entries = this->Entries<Real>().data();
  for (const Pair& pair : this->Pairs)
  {
    const Real product = a[pair.I] * b[pair.J] + a[pair.J] * b[pair.I];
    for (int entry = pair.Begin; entry < pair.End; ++entry)
    {
      out[entries[entry].K] += entries[entry].Weight * product;
    }
  }
}

template <typename Real>
Real HarmonicProduct::TripleIntegral(const Real* a, const Real* b, const Real* c) const
{
  Real product[HarmonicCount(MaxHarmonicBands)];
  this->Product(a, b, product);
  Real sum = 0;
  for (int k = 0; k < HarmonicCount(this->NumberOfBands); ++k)
  {
    sum += product[k] * c[k];
  }
  return sum;
}

template <typename Real>
void HarmonicProduct::Matrix(const Real* a, Real* matrix) const
{
  const int count = HarmonicCount(this->NumberOfBands);
  std::fill_n(matrix, count * count, Real(0));
  const Entry<Real>* entries = this->Entries<Real>().data();
  for (const Pair& pair : this->Pairs)
  {
    for (int entry = pair.Begin; entry < pair.End; ++entry)
    {
      Real* row = matrix + entries[entry].K * count;
      row[pair.I] += entries[entry].Weight * a[pair.J];
      row[pair.J] += entries[entry].Weight * a[pair.I];
    }
  }
}

template void HarmonicProduct::Product(const float*, const float*, float*) const;
template void HarmonicProduct::Product(const double*, const double*, double*) const;
template float HarmonicProduct::TripleIntegral(const float*, const float*, const float*) const;
template double HarmonicProduct::TripleIntegral(const double*, const double*, const double*) const;
template void HarmonicProduct::Matrix(const float*, float*) const;
template void HarmonicProduct::Matrix(const double*, double*) const;

} // namespace skyline
