// SPDX-License-Identifier: BSD-3-Clause
// The sRGB codes of IEC 61966-2-1, like EncodeSrgb and DecodeSrgb in ToneMap.h.
vec3 SkylineDecode(vec3 code)
{
  vec3 c = clamp(code, 0.0, 1.0);
  return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, lessThanEqual(c, vec3(0.04045)));
}

vec3 SkylineEncode(vec3 linear)
{
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(
    1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}
