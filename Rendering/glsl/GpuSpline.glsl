// SPDX-License-Identifier: BSD-3-Clause
// Interpolates a level of the pyramid at posts, along one axis, by a cubic B-spline of four
// samples.
// taps: for each post the four weights, and in the row above the numbers of the four samples.
uniform sampler2D samples;
uniform sampler2D taps;
uniform int vertical;

vec2 Sample(ivec2 at, float place)
{
  return texelFetch(samples, vertical != 0 ? ivec2(at.x, int(place)) : ivec2(int(place), at.y), 0).xy;
}

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  int post = vertical != 0 ? at.y : at.x;
  vec4 weight = texelFetch(taps, ivec2(post, 0), 0);
  vec4 place = texelFetch(taps, ivec2(post, 1), 0);
  vec2 sum = weight.x * Sample(at, place.x) + weight.y * Sample(at, place.y) +
    weight.z * Sample(at, place.z) + weight.w * Sample(at, place.w);
  gl_FragData[0] = vec4(sum, 0.0, max(texCoord.x, 1.0));
}
