// SPDX-License-Identifier: BSD-3-Clause
// The function ToneMap of ToneMap.h. Its constants are passed as defines.
float SkylineToneCurve(float luminance)
{
  float spread = SKYLINE_TONE_GREY * pow(luminance / SKYLINE_TONE_GREY, SKYLINE_TONE_CONTRAST);
  float room = SKYLINE_TONE_WHITE - SKYLINE_TONE_KNEE;
  float bent = SKYLINE_TONE_WHITE - room / (1.0 + (spread - SKYLINE_TONE_KNEE) / room);
  return spread <= SKYLINE_TONE_KNEE ? spread : bent;
}

vec3 SkylineToneMap(vec3 light)
{
  // If one argument is NaN, min and max may return either argument. Therefore the code compares.
  vec3 c = mix(vec3(0.0), min(light, vec3(1.0e25)), greaterThan(light, vec3(0.0)));
  float before = dot(c, vec3(0.2126, 0.7152, 0.0722));
  if (!(before > 0.0))
  {
    return vec3(0.0);
  }
  float after = SkylineToneCurve(before);
  c = c / before * after;
  float brightest = max(c.r, max(c.g, c.b));
  if (brightest > SKYLINE_TONE_WHITE)
  {
    float kept = (SKYLINE_TONE_WHITE - after) / (brightest - after);
    c = clamp(after + kept * (c - after), 0.0, SKYLINE_TONE_WHITE);
  }
  return c;
}

