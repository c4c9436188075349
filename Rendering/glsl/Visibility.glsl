// SPDX-License-Identifier: BSD-3-Clause
// E = integral of L V max(0, n.d), with 16 coefficients for each factor. C++ has already multiplied
// the tensor of the triple product by the light.
// A clamped cosine has no part in band 3, so nine functions of the normal remain. For each of them
// skylineLight holds four vectors each of red, of green and of blue. Snyder & Nowrouzezahrai
// (2008), section 2; Ramamoorthi & Hanrahan (2001), equation 3.
uniform sampler2D skylineHarmonics0;
uniform sampler2D skylineHarmonics1;
uniform sampler2D skylineHarmonics2;
uniform sampler2D skylineHarmonics3;
uniform sampler2D skylineGradient; // dz/dx, dz/dy
uniform vec4 skylineLight[108];

float SkylineDot(mat4 v, int first)
{
  return dot(v[0], skylineLight[first]) + dot(v[1], skylineLight[first + 1]) +
    dot(v[2], skylineLight[first + 2]) + dot(v[3], skylineLight[first + 3]);
}

vec3 SkylineIrradiance(vec2 post)
{
  mat4 v = mat4(texture(skylineHarmonics0, post), texture(skylineHarmonics1, post),
    texture(skylineHarmonics2, post), texture(skylineHarmonics3, post));
  vec3 n = normalize(vec3(-texture(skylineGradient, post).xy, 1.0));
  // The shapes of the functions of the bands 0 to 2. skylineLight includes their factors.
  float shape[9] = float[9](1.0, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3.0 * n.z * n.z - 1.0,
    n.x * n.z, n.x * n.x - n.y * n.y);
  vec3 light = vec3(0.0);
  for (int j = 0; j < 9; ++j)
  {
    light += shape[j] *
      vec3(SkylineDot(v, 12 * j), SkylineDot(v, 12 * j + 4), SkylineDot(v, 12 * j + 8));
  }
  return max(light, 0.0);
}
