// SPDX-License-Identifier: BSD-3-Clause
// Adds the sky above four horizons, as spherical harmonics, to the target: see
// VisibilityAccumulator. C++ generates the integrals from ElevationIntegral.h.
// horizons: four angles per post. weights: the sines and the cosines of the four azimuths, then six
// texels of WedgeWeights for each order m. wholes: the sums without horizons, for the upward,
// eastward and northward components of the normal; they are added if whole is 1.
uniform sampler2D horizons;
uniform sampler2D weights;
uniform float whole;
uniform vec4 wholes[24];

vec4 Weight(int m, int which)
{
  return texelFetch(weights, ivec2(2 + 6 * m + which, 0), 0);
}

//Skyline::Transfer
uniform sampler2D gradients; // dz/dx, dz/dy

//Skyline::Sum
void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 h = max(texelFetch(horizons, at, 0), 0.0);
  vec2 gradient = vec2(0.0);
  float up = min(1.0, texCoord.x + 2.0);
  //Fill::Plane
  vec4 s, c;
  SineAndCosine(h, s, c);
  vec4 q = s * s;
  vec4 sc = s * c;
  //Fill::Integrals
}

//Skyline::Plane
  gradient = texelFetch(gradients, at, 0).xy;
  up /= sqrt(1.0 + dot(gradient, gradient));
  vec4 rise = gradient.x * texelFetch(weights, ivec2(0, 0), 0) +
    gradient.y * texelFetch(weights, ivec2(1, 0), 0);
  h = max(h, AngleOf(rise));
