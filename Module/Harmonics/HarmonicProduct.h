// SPDX-License-Identifier: BSD-3-Clause
// Products of functions that are given by their spherical harmonics.
#ifndef skyline_HarmonicProduct_h
#define skyline_HarmonicProduct_h

#include "SkylineCoreModule.h" // for the export macro

#include <vector>

namespace skyline
{

/// The integral of the product of three basis functions: T_ijk = integral of Y_i Y_j Y_k over the
/// sphere.
struct HarmonicTerm
{
  int I, J, K; ///< I <= J <= K
  double Value;
};

/// The sparse tensor of triple products for 2 to 8 bands, and the products that use it. Vectors
/// have bands * bands coefficients; Real is float or double. Snyder & Nowrouzezahrai 2008, section
/// 2 (equation 2). The loops are unrolled as in Snyder 2006, "Code Generation and Factoring for
/// Fast Evaluation of Low-order Spherical Harmonic Products and Squares".
class SKYLINECORE_EXPORT HarmonicProduct
{
public:
  /// The tensor for a number of bands, computed at its first use. Throws std::invalid_argument
  /// unless the number is 2 to 8.
  static const HarmonicProduct& ForBands(int bands);

  int Bands() const { return this->NumberOfBands; }

  /// All non-zero terms.
  const std::vector<HarmonicTerm>& Terms() const { return this->Tensor; }

  /// The product of two functions, projected to the same bands:
  /// out_k = sum over i, j of T_ijk a_i b_j. `out` must be neither a nor b.
  template <typename Real>
  void Product(const Real* a, const Real* b, Real* out) const;

  /// The integral of the product of three functions: sum over i, j, k of T_ijk a_i b_j c_k.
  template <typename Real>
  Real TripleIntegral(const Real* a, const Real* b, const Real* c) const;

  /// The symmetric matrix of the product with a: Product(a, b) = matrix b. It has bands^2 rows of
  /// bands^2 numbers. Using it is cheaper if one of the two functions is the same at all posts.
  template <typename Real>
  void Matrix(const Real* a, Real* matrix) const;

private:
  explicit HarmonicProduct(int bands);
  template <int Bands>
  static const HarmonicProduct& Built();

  /// All terms that share two indices i <= j.
  struct Pair
  {
    int I, J;
    int Begin, End; ///< range of its entries
  };
  /// T_ijk, or half of it if i = j: the weight of a_i b_j + a_j b_i in element k.
  template <typename Real>
  struct Entry
  {
    int K;
    Real Weight;
  };
  template <typename Real>
  const std::vector<Entry<Real>>& Entries() const;

  int NumberOfBands;
  std::vector<HarmonicTerm> Tensor;
  std::vector<Pair> Pairs;
  std::vector<Entry<float>> Floats;
  std::vector<Entry<double>> Doubles;
};

} // namespace skyline

#endif
