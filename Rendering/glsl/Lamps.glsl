// SPDX-License-Identifier: BSD-3-Clause
// The irradiance of up to four lamps at radiance 1, one per channel, times the radiance of each
// lamp.
uniform sampler2D skylineLampTexture;
uniform vec3 skylineLampRadiance[4];

vec3 SkylineLamps(vec2 post)
{
  vec4 e = max(texture(skylineLampTexture, post), 0.0);
  return e.x * skylineLampRadiance[0] + e.y * skylineLampRadiance[1] +
    e.z * skylineLampRadiance[2] + e.w * skylineLampRadiance[3];
}
//Skyline::Impl
  skylineLight += SkylineLamps(skylinePostVSOutput);
