// SPDX-License-Identifier: BSD-3-Clause
// Angles from slopes for vectors of floats. As usual with Highway, this file is included once per
// processor target, and its include guard toggles.
#if defined(skyline_FastMath_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef skyline_FastMath_inl_h
#undef skyline_FastMath_inl_h
#else
#define skyline_FastMath_inl_h
#endif

#include "Shared/Constants.h"

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace skyline
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// atan z for 0 <= z <= 1: z + z^3 P(z^2). P is our own minimax fit (Lawson's iteration); the fit
/// has an error of at most 7.4e-9 rad, with rounding 1.0e-7.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V AtanUnit(D d, V z)
{
  const V q = hn::Mul(z, z);
  V p = hn::Set(d, AngleTerms[0]);
  p = hn::MulAdd(p, q, hn::Set(d, AngleTerms[1]));
  p = hn::MulAdd(p, q, hn::Set(d, AngleTerms[2]));
  p = hn::MulAdd(p, q, hn::Set(d, AngleTerms[3]));
  p = hn::MulAdd(p, q, hn::Set(d, AngleTerms[4]));
  p = hn::MulAdd(p, q, hn::Set(d, AngleTerms[5]));
  p = hn::MulAdd(p, q, hn::Set(d, AngleTerms[6]));
  p = hn::MulAdd(p, q, hn::Set(d, AngleTerms[7]));
  return hn::MulAdd(hn::Mul(z, q), p, z);
}

/// asin m for 0 <= m <= sqrt(1/2), from m and its square: m + m^3 P(m^2), fitted in the same way;
/// the fit has an error of at most 7.4e-9 rad, with rounding 1.0e-7.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V AsinLow(D d, V m, V square)
{
  V p = hn::Set(d, 1.237216070e-01f);
  p = hn::MulAdd(p, square, hn::Set(d, -1.153045818e-01f));
  p = hn::MulAdd(p, square, hn::Set(d, 9.340120107e-02f));
  p = hn::MulAdd(p, square, hn::Set(d, 1.043058466e-02f));
  p = hn::MulAdd(p, square, hn::Set(d, 4.762431607e-02f));
  p = hn::MulAdd(p, square, hn::Set(d, 7.478348911e-02f));
  p = hn::MulAdd(p, square, hn::Set(d, 1.666723490e-01f));
  return hn::MulAdd(hn::Mul(m, square), p, m);
}

/// atan t in a unit in which a right angle is `quarter` and a radian is `unit`. Exactly a right
/// angle for |t| >= 1e18. t may be infinite but not NaN.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V AtanIn(D d, V t, float unit, float quarter)
{
  const V one = hn::Set(d, 1.0f);
  const V size = hn::Abs(t);
  // For |t| > 1, atan t = right angle - atan(1 / t).
  const V z = hn::Div(hn::Min(size, one), hn::Max(size, one));
  const V low = hn::Mul(AtanUnit(d, z), hn::Set(d, unit));
  return hn::CopySign(hn::IfThenElse(hn::Gt(size, one), hn::Sub(hn::Set(d, quarter), low), low), t);
}

/// atan t in radians; error at most 1.4e-7.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V Atan(D d, V t)
{
  return AtanIn(d, t, 1.0f, static_cast<float>(0.5 * Pi));
}

/// atan t in degrees; error at most 8e-6.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V AtanDegrees(D d, V t)
{
  return AtanIn(d, t, static_cast<float>(DegreesPerRadian), 90.0f);
}

/// Functions of the elevation h of a slope t = tan h, as sums over the sky need them.
template <class V>
struct SlopeTerms
{
  V Cos;       ///< cos h
  V CosSquare; ///< cos^2 h
  V SinSquare; ///< sin^2 h
  V Arc;       ///< |h| where |h| < 45 degrees, else 90 degrees - |h|; radians
  V Size;      ///< |sin h|
};

/// The terms of a slope of at most 1e18 in absolute value, whose square is a finite float.
template <class D, class V = hn::Vec<D>>
HWY_INLINE SlopeTerms<V> TermsOfSlope(D d, V t)
{
  const V one = hn::Set(d, 1.0f);
  const V square = hn::Mul(t, t);
  SlopeTerms<V> terms;
  terms.CosSquare = hn::Div(one, hn::Add(one, square));
  terms.Cos = hn::Sqrt(terms.CosSquare);
  terms.SinSquare = hn::Mul(square, terms.CosSquare);
  terms.Size = hn::Mul(hn::Abs(t), terms.Cos);
  terms.Arc = AsinLow(d, hn::Min(terms.Size, terms.Cos), hn::Min(terms.SinSquare, terms.CosSquare));
  return terms;
}

/// |h| from the terms of a slope, radians.
template <class D, class V>
HWY_INLINE V SizeOfAngle(D d, const SlopeTerms<V>& terms)
{
  return hn::IfThenElse(hn::Lt(terms.Size, terms.Cos), terms.Arc,
    hn::Sub(hn::Set(d, static_cast<float>(0.5 * Pi)), terms.Arc));
}

/// 90 degrees - |h| from the terms of a slope, in radians; accurate for small angles.
template <class D, class V>
HWY_INLINE V ZenithAngle(D d, const SlopeTerms<V>& terms)
{
  return hn::IfThenElse(hn::Lt(terms.Size, terms.Cos),
    hn::Sub(hn::Set(d, static_cast<float>(0.5 * Pi)), terms.Arc), terms.Arc);
}

} // namespace HWY_NAMESPACE
} // namespace skyline
HWY_AFTER_NAMESPACE();

#endif
