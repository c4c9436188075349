// SPDX-License-Identifier: BSD-3-Clause
// E = T . L: the product of the 16 transfer coefficients of a post (visibility times cosine) and
// those of the light.
// skylineHarmonics: four textures of four coefficients each. skylineLight: four vectors each of
// red, of green and of blue.
uniform sampler2D skylineHarmonics0;
uniform sampler2D skylineHarmonics1;
uniform sampler2D skylineHarmonics2;
uniform sampler2D skylineHarmonics3;
uniform vec4 skylineLight[12];

float SkylineDot(mat4 t, int first)
{
  return dot(t[0], skylineLight[first]) + dot(t[1], skylineLight[first + 1]) +
    dot(t[2], skylineLight[first + 2]) + dot(t[3], skylineLight[first + 3]);
}

vec3 SkylineIrradiance(vec2 post)
{
  mat4 t = mat4(texture(skylineHarmonics0, post), texture(skylineHarmonics1, post),
    texture(skylineHarmonics2, post), texture(skylineHarmonics3, post));
  return max(vec3(SkylineDot(t, 0), SkylineDot(t, 4), SkylineDot(t, 8)), 0.0);
}
