// SPDX-License-Identifier: BSD-3-Clause
// Light that was computed before: the irradiance of each post.
uniform sampler2D skylineIrradiance;

vec3 SkylineIrradiance(vec2 post)
{
  return max(texture(skylineIrradiance, post).rgb, 0.0);
}
