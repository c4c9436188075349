// SPDX-License-Identifier: BSD-3-Clause
// Numbers that more than one file needs, each once, with its closed form or its source.
#ifndef skyline_Constants_h
#define skyline_Constants_h

namespace skyline
{

constexpr double Pi = 3.14159265358979323846;   ///< acos(-1)
constexpr double DegreesPerRadian = 180.0 / Pi; ///< 180 / pi
constexpr double RadiansPerDegree = Pi / 180.0; ///< pi / 180

/// Tangent of the horizon where no terrain lies in a direction. Its square still is a finite float,
/// and atan of it is -90 degrees in float.
constexpr float NoTerrainSlope = -1.0e18f;

/// Height of a post without surface: low enough that any weight of it hides an edge (the smallest
/// weight is 1e-9, the largest distance 1e7 m: -1e30 * 1e-9 / 1e7 = -1e14, far under any slope of
/// terrain), high enough that sums and products stay finite floats.
constexpr float MissingHeight = -1.0e30f;

/// Terrestrial refraction: radius of the Earth over radius of a light ray near the ground. The
/// value surveyors use since Gauss.
constexpr double TerrestrialRefraction = 0.13;

/// Of atan z, 0 <= z <= 1: z + z q p(q) with q = z z, the coefficients of p from the highest power;
/// a minimax fit, for FastMath-inl.h and GpuAngles.glsl.
constexpr float AngleTerms[8] = { 2.622244414e-03f, -1.513253618e-02f, 4.112185910e-02f,
  -7.366705686e-02f, 1.057393178e-01f, -1.418597549e-01f, 1.999039650e-01f, -3.333298564e-01f };

/// Mean angular radius of the sun seen from the Earth, degrees: asin(695700 km / 149597870.7 km).
constexpr double MeanSunRadius = 0.26645;

/// Suns up to this angular radius, degrees, are lit as a whole and shadowed by their lit part. The parts of
/// larger discs shine at different angles: those are key lights.
constexpr double LargestSunRadius = 3.0;

} // namespace skyline

#endif
