// SPDX-License-Identifier: BSD-3-Clause
// Constants that several files need, each defined once with its closed form or its source.
#ifndef skyline_Constants_h
#define skyline_Constants_h

namespace skyline
{

constexpr double Pi = 3.14159265358979323846;   ///< acos(-1)
constexpr double DegreesPerRadian = 180.0 / Pi; ///< 180 / pi
constexpr double RadiansPerDegree = Pi / 180.0; ///< pi / 180

/// Slope of the horizon in a direction without terrain. Its square is a finite float, and its atan
/// is -90 degrees in float.
constexpr float NoTerrainSlope = -1.0e18f;

/// Height of a missing post. It is so low that any share of it makes an edge lower than all terrain
/// (the smallest weight is 1e-9 and the greatest distance 1e7 m: -1e30 * 1e-9 / 1e7 = -1e14), and
/// high enough that sums and products are finite floats.
constexpr float MissingHeight = -1.0e30f;

/// Refraction coefficient: radius of the Earth divided by the radius of a light ray near the
/// ground. This is the value that surveyors have used since Gauss.
constexpr double TerrestrialRefraction = 0.13;

/// Coefficients for atan z, 0 <= z <= 1: z + z q p(q), where q = z z. The coefficients of p start
/// with the highest power. They are a minimax fit for FastMath-inl.h and GpuAngles.glsl.
constexpr float AngleTerms[8] = { 2.622244414e-03f, -1.513253618e-02f, 4.112185910e-02f,
  -7.366705686e-02f, 1.057393178e-01f, -1.418597549e-01f, 1.999039650e-01f, -3.333298564e-01f };

/// Mean angular radius of the sun as seen from the Earth, degrees: asin(695700 km / 149597870.7
/// km).
constexpr double MeanSunRadius = 0.26645;

/// Largest angular radius, in degrees, of a sun whose shadow is computed as one lit share. The
/// parts of larger discs meet the surface at clearly different angles; such discs are computed as
/// key lights.
constexpr double LargestSunRadius = 3.0;

} // namespace skyline

#endif
