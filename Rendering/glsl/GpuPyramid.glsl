// SPDX-License-Identifier: BSD-3-Clause
// Horizons of four azimuths from the height pyramid, as in HorizonPyramid.cxx: Snyder &
// Nowrouzezahrai (2008), section 4.
// casters, receivers: heights of the levels at the posts, times coverage, and the coverage.
// reaches: three texels per level, one row per azimuth:
// 1. the offset to the caster in posts (whole column and row, then their fractional parts);
// 2. the layers of the caster and of the receiver, 1 / distance to the caster (1/m), and its drop
// as a slope;
// 3. the columns and rows of the receivers whose casters lie in the data.
uniform sampler3D casters;
uniform sampler3D receivers;
uniform sampler2D reaches;
uniform int levels;
uniform ivec2 tile; // the post of the first texel

//Skyline::Whole
float Height(vec2 value)
{
  return value.x;
}

bool Counts(vec2 here, vec2 there)
{
  return true;
}

//Skyline::Missing
const float CasterCoverage = 0.5;
const float ReceiverCoverage = 1.0e-6;

float Height(vec2 value)
{
  return value.x / max(value.y, ReceiverCoverage);
}

bool Counts(vec2 here, vec2 there)
{
  return here.y >= ReceiverCoverage && there.y >= CasterCoverage;
}

//Skyline::Slopes
// The derivative of a level (equation 2); 0 if it is negative or if no terrain is read.
float Slope(int level, int azimuth, ivec2 at, vec2 here)
{
  vec4 inside = texelFetch(reaches, ivec2(3 * level + 2, azimuth), 0);
  vec2 post = vec2(at + tile);
  if (post.x < inside.x || post.x >= inside.y || post.y < inside.z || post.y >= inside.w)
  {
    return 0.0;
  }
  vec4 reach = texelFetch(reaches, ivec2(3 * level, azimuth), 0);
  vec4 how = texelFetch(reaches, ivec2(3 * level + 1, azimuth), 0);
  ivec3 low = ivec3(at + ivec2(reach.xy), int(how.x));
  ivec3 east = ivec3(reach.z > 0.0 ? 1 : 0, 0, 0);
  ivec3 north = ivec3(0, reach.w > 0.0 ? 1 : 0, 0);
  vec2 west = (1.0 - reach.w) * texelFetch(casters, low, 0).xy +
    reach.w * texelFetch(casters, low + north, 0).xy;
  vec2 next = (1.0 - reach.w) * texelFetch(casters, low + east, 0).xy +
    reach.w * texelFetch(casters, low + east + north, 0).xy;
  vec2 there = (1.0 - reach.z) * west + reach.z * next;
  float slope = (Height(there) - Height(here)) * how.z - how.w;
  return Counts(here, there) ? max(slope, 0.0) : 0.0;
}

vec4 Slopes(int level, ivec2 at)
{
  float layer = texelFetch(reaches, ivec2(3 * level + 1, 0), 0).y; // equal for all azimuths
  vec2 here = texelFetch(receivers, ivec3(at, int(layer)), 0).xy;
  return vec4(Slope(level, 0, at, here), Slope(level, 1, at, here), Slope(level, 2, at, here),
    Slope(level, 3, at, here));
}

//Skyline::Greatest
vec4 Horizons(ivec2 at)
{
  vec4 best = vec4(0.0);
  for (int level = 0; level < levels; ++level)
  {
    best = max(best, Slopes(level, at));
  }
  return AngleOf(best);
}

//Skyline::Spline
// The greatest value, at the knots and halfway between them, of the cubic B-spline through the
// angles of the levels. The first and the last angle are repeated (equations 4 and 5).
vec4 Horizons(ivec2 at)
{
  vec4 third = AngleOf(Slopes(0, at));
  vec4 second = third;
  vec4 first = third;
  vec4 best = vec4(0.0);
  for (int level = 1; level <= levels; ++level)
  {
    vec4 value = level < levels ? AngleOf(Slopes(level, at)) : third;
    best = max(best, (4.0 * third + (second + value)) / 6.0);
    if (level > 1)
    {
      best = max(best, (23.0 * (second + third) + (first + value)) / 48.0);
    }
    first = second;
    second = third;
    third = value;
  }
  return min(best, RightAngle);
}

//Skyline::Main
void main()
{
  gl_FragData[0] = Horizons(ivec2(gl_FragCoord.xy)) * min(1.0, texCoord.x + 2.0);
}
