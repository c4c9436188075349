// SPDX-License-Identifier: BSD-3-Clause
// Computes a level of the pyramid from the next finer one by bilinear interpolation, as
// HeightPyramid::Decimate does.
// A texel holds a height times its coverage, and the coverage. across, along: for each sample of an
// axis, the two finer samples and the weight of the second one.
uniform sampler2D fine;
uniform sampler2D across;
uniform sampler2D along;

vec2 Fine(float column, float row)
{
  return texelFetch(fine, ivec2(int(column), int(row)), 0).xy;
}

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec3 x = texelFetch(across, ivec2(at.x, 0), 0).xyz;
  vec3 y = texelFetch(along, ivec2(at.y, 0), 0).xyz;
  vec2 first = Fine(x.x, y.x);
  first += y.z * (Fine(x.x, y.y) - first);
  vec2 second = Fine(x.y, y.x);
  second += y.z * (Fine(x.y, y.y) - second);
  gl_FragData[0] = vec4(first + x.z * (second - first), 0.0, max(texCoord.x, 1.0));
}
