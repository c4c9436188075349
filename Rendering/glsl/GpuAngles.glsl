// SPDX-License-Identifier: BSD-3-Clause
// Angles and their sines, correct to the rounding of floats. The driver's own functions are not
// used, because their accuracy varies.
//Fill::Pi
//Fill::AngleTerms
const float RightAngle = 0.5 * SkylinePi;

// atan t, by the polynomial of AngleTerms, as in FastMath-inl.h.
vec4 AngleOf(vec4 t)
{
  vec4 size = abs(t);
  vec4 z = min(size, 1.0) / max(size, 1.0);
  vec4 q = z * z;
  vec4 p = vec4(AngleTerms[0]);
  for (int k = 1; k < 8; ++k)
  {
    p = p * q + AngleTerms[k];
  }
  vec4 low = z + z * q * p;
  return mix(low, RightAngle - low, greaterThan(size, vec4(1.0))) * sign(t);
}

// sin h and cos h for |h| up to 45 degrees, by Taylor's series, with errors of 2e-9 and 2e-10.
vec4 LowSine(vec4 h)
{
  vec4 q = h * h;
  vec4 p = ((q / 362880.0 - 1.0 / 5040.0) * q + 1.0 / 120.0) * q - 1.0 / 6.0;
  return h + h * q * p;
}

vec4 LowCosine(vec4 h)
{
  vec4 q = h * h;
  vec4 p = ((-q / 3628800.0 + 1.0 / 40320.0) * q - 1.0 / 720.0) * q + 1.0 / 24.0;
  return 1.0 - 0.5 * q + q * q * p;
}

// sin h and cos h for |h| up to a right angle.
void SineAndCosine(vec4 h, out vec4 sine, out vec4 cosine)
{
  vec4 size = abs(h);
  vec4 low = min(size, RightAngle - size);
  bvec4 steep = greaterThan(size, vec4(0.5 * RightAngle));
  vec4 s = LowSine(low);
  vec4 c = LowCosine(low);
  sine = mix(s, c, steep) * sign(h);
  cosine = mix(c, s, steep);
}
