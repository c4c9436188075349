// SPDX-License-Identifier: BSD-3-Clause
#include "Harmonics/HarmonicProduct.h"

#include "HarmonicTesting.h"
#include "Harmonics/SphericalHarmonics.h"
#include "SphereQuadrature.h"
#include "Testing/Module/NumberTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace skyline
{
namespace testing
{
namespace
{

constexpr int LargestCount = HarmonicCount(MaxHarmonicBands);

/// In a product of random vectors of 64 coefficients in [-1, 1], each sum has up to some hundred
/// terms of 0.1, in floats.
constexpr double FloatSumBound = 2.0e-5;

class HarmonicProductBands : public ::testing::TestWithParam<int>
{
};

TEST(HarmonicProduct, TensorOfTheReference)
{
  const std::vector<TableRow> rows = ReadTable("harmonics/sh_triple_product_order4.csv");
  std::map<std::tuple<int, int, int>, double> expected;
  for (const TableRow& row : rows)
  {
    expected[{ std::stoi(row.at("i")), std::stoi(row.at("j")), std::stoi(row.at("k")) }] =
      Number(row, "value");
  }
  const std::vector<HarmonicTerm>& terms = HarmonicProduct::ForBands(5).Terms();
  ASSERT_EQ(expected.size(), 238u);
  ASSERT_EQ(terms.size(), expected.size());
  for (const HarmonicTerm& term : terms)
  {
    const auto found = expected.find({ term.I, term.J, term.K });
    ASSERT_NE(found, expected.end()) << term.I << " " << term.J << " " << term.K;
    EXPECT_NEAR(term.Value, found->second, AlgebraBound);
  }
}

TEST(HarmonicProduct, ProductOfTheReference)
{
  const std::vector<TableRow> rows = ReadTable("harmonics/sh_product_example_order4.csv");
  ASSERT_EQ(rows.size(), 25u);
  std::vector<double> a, b, product(25);
  for (const TableRow& row : rows)
  {
    a.push_back(Number(row, "a"));
    b.push_back(Number(row, "b"));
  }
  HarmonicProduct::ForBands(5).Product(a.data(), b.data(), product.data());
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    EXPECT_NEAR(product[k], Number(rows[k], "c_k = sum_ij a_i b_j G_ijk"), AlgebraBound) << k;
  }
}

TEST(HarmonicProduct, BandsOutOfRange)
{
  for (const int bands : { -1, 0, 1, 9 })
  {
    try
    {
      HarmonicProduct::ForBands(bands);
      ADD_FAILURE() << bands;
    }
    catch (const std::invalid_argument& failure)
    {
      EXPECT_EQ(
        failure.what(), std::to_string(bands) + " bands of spherical harmonics; give 2 to 8");
    }
  }
}

TEST_P(HarmonicProductBands, BruteForce)
{
  const int bands = GetParam(), count = HarmonicCount(bands);
  const std::vector<double> a = RandomVector(count, 1), b = RandomVector(count, 2);
  const std::vector<double> c = RandomVector(count, 3);
  std::vector<double> expected(count, 0.0);
  double expectedTriple = 0.0;
  // The product of three polynomials of degree bands - 1.
  VisitSphere(2 * bands, -1.0,
    [&](double x, double y, double z, double weight)
    {
      double values[LargestCount];
      EvaluateHarmonics(bands, x, y, z, values);
      double first = 0.0, second = 0.0, third = 0.0;
      for (int i = 0; i < count; ++i)
      {
        first += a[i] * values[i];
        second += b[i] * values[i];
        third += c[i] * values[i];
      }
      for (int i = 0; i < count; ++i)
      {
        expected[i] += weight * first * second * values[i];
      }
      expectedTriple += weight * first * second * third;
    });

  const HarmonicProduct& product = HarmonicProduct::ForBands(bands);
  EXPECT_EQ(product.Bands(), bands);
  std::vector<double> out(count + 1, 99.0), swapped(count);
  product.Product(a.data(), b.data(), out.data());
  product.Product(b.data(), a.data(), swapped.data());
  const double largest = std::abs(*std::max_element(expected.begin(), expected.end(),
    [](double p, double q) { return std::abs(p) < std::abs(q); }));
  for (int k = 0; k < count; ++k)
  {
    EXPECT_NEAR(out[k], expected[k], AlgebraBound * std::max(1.0, largest)) << k;
    EXPECT_NEAR(swapped[k], out[k], AlgebraBound) << k;
  }
  EXPECT_EQ(out[count], 99.0) << "the product wrote beyond the bands";
  EXPECT_NEAR(
    product.TripleIntegral(a.data(), b.data(), c.data()), expectedTriple, AlgebraBound * count);

  const std::vector<float> af(a.begin(), a.end()), bf(b.begin(), b.end()), cf(c.begin(), c.end());
  std::vector<float> outf(count);
  product.Product(af.data(), bf.data(), outf.data());
  for (int k = 0; k < count; ++k)
  {
    EXPECT_NEAR(outf[k], expected[k], FloatSumBound) << k;
  }
  EXPECT_NEAR(
    product.TripleIntegral(af.data(), bf.data(), cf.data()), expectedTriple, FloatSumBound * bands);
}

TEST_P(HarmonicProductBands, MatrixIsTheProductWithOneFunction)
{
  const int bands = GetParam(), count = HarmonicCount(bands);
  const std::vector<double> a = RandomVector(count, 4), b = RandomVector(count, 5);
  const HarmonicProduct& product = HarmonicProduct::ForBands(bands);
  std::vector<double> matrix(count * count), out(count);
  product.Matrix(a.data(), matrix.data());
  product.Product(a.data(), b.data(), out.data());
  for (int k = 0; k < count; ++k)
  {
    double sum = 0.0;
    for (int j = 0; j < count; ++j)
    {
      sum += matrix[k * count + j] * b[j];
      EXPECT_NEAR(matrix[k * count + j], matrix[j * count + k], AlgebraBound);
    }
    EXPECT_NEAR(sum, out[k], 10.0 * AlgebraBound) << k;
  }
  const std::vector<float> af(a.begin(), a.end());
  std::vector<float> matrixf(count * count);
  product.Matrix(af.data(), matrixf.data());
  for (int i = 0; i < count * count; ++i)
  {
    EXPECT_NEAR(matrixf[i], matrix[i], FloatSumBound);
  }
}

// If the factors are turned around the vertical axis, the product turns with them.
TEST_P(HarmonicProductBands, TurnsWithItsFactors)
{
  const int bands = GetParam(), count = HarmonicCount(bands);
  std::vector<double> a = RandomVector(count, 6), b = RandomVector(count, 7);
  const HarmonicProduct& product = HarmonicProduct::ForBands(bands);
  std::vector<double> first(count), second(count);
  product.Product(a.data(), b.data(), first.data());
  RotateAboutVertical(bands, 1.1, first.data(), first.data());
  RotateAboutVertical(bands, 1.1, a.data(), a.data());
  RotateAboutVertical(bands, 1.1, b.data(), b.data());
  product.Product(a.data(), b.data(), second.data());
  for (int k = 0; k < count; ++k)
  {
    EXPECT_NEAR(first[k], second[k], 10.0 * AlgebraBound) << k;
  }
}

TEST_P(HarmonicProductBands, TheConstantOneChangesNothing)
{
  const int bands = GetParam(), count = HarmonicCount(bands);
  const std::vector<double> a = RandomVector(count, 8);
  std::vector<double> one(count, 0.0), out(count);
  one[0] = std::sqrt(4.0 * Pi);
  HarmonicProduct::ForBands(bands).Product(one.data(), a.data(), out.data());
  for (int k = 0; k < count; ++k)
  {
    EXPECT_NEAR(out[k], a[k], AlgebraBound) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Bands, HarmonicProductBands, ::testing::Range(2, MaxHarmonicBands + 1));

} // namespace
} // namespace testing
} // namespace skyline
