// SPDX-License-Identifier: BSD-3-Clause
// Light of the sun and the sky on objects that stand or fly over a height field, from the shadow
// heights of its posts: the counterpart of vtkHeightFieldShadowReceiver (see ShadowHeightPenumbra.h).
// The light of the sky is the sum of nine functions of the normal, as if nothing hid the sky.
// SKYLINE_NORMAL: 0 for the normals of the faces, 1 for those of the points, 2 for none, which is
// lit as if it faced the sun.
//Fill::Pi
uniform sampler2D skylineShadow; // for the upper and the lower limb, metres above the base
uniform vec2 skylinePosts;       // columns and rows
uniform vec4 skylineDisc;        // elevation, 1 / radius, tangents of the upper and the lower limb
uniform vec4 skylineFade;        // part lit without shadow, penumbra depth, slack, 1: two limbs
uniform vec3 skylineSunDirection;
uniform vec3 skylineSun; // irradiance of a plane that faces the sun
uniform vec4 skylineSky[9];
in vec3 skylineWorldVSOutput; // metres; z is the height above the base

vec3 SkylineNormal()
{
#if SKYLINE_NORMAL == 2
  return skylineSunDirection;
#else
  // The side that the viewer sees.
  vec3 face = normalize(cross(dFdx(skylineWorldVSOutput), dFdy(skylineWorldVSOutput)));
#if SKYLINE_NORMAL == 1
  vec3 normal = normalize(skylineNormalVSOutput);
  return dot(normal, face) < 0.0 ? -normal : normal;
#else
  return face;
#endif
#endif
}

// The shadow heights at a position, interpolated linearly in each triangle of the surface.
bool SkylineShadows(vec2 post, out vec2 shadows)
{
  vec2 place = post * skylinePosts - 0.5;
  vec2 last = skylinePosts - 1.0;
  if (any(lessThan(place, vec2(-0.001))) || any(greaterThan(place, last + 0.001)))
  {
    return false;
  }
  vec2 corner = min(floor(max(place, 0.0)), last - 1.0);
  vec2 part = clamp(place - corner, 0.0, 1.0);
  ivec2 at = ivec2(corner);
  vec2 near = texelFetch(skylineShadow, at, 0).xy;
  vec2 far = texelFetch(skylineShadow, at + ivec2(1, 1), 0).xy;
  ivec2 aside = part.x >= part.y ? ivec2(1, 0) : ivec2(0, 1);
  vec2 side = texelFetch(skylineShadow, at + aside, 0).xy;
  shadows = (1.0 - max(part.x, part.y)) * near + abs(part.x - part.y) * side +
    min(part.x, part.y) * far;
  return true;
}

float SkylineLit(vec2 post, float z)
{
  vec2 shadows;
  if (!SkylineShadows(post, shadows) || z + skylineFade.z >= shadows.y)
  {
    return skylineFade.x;
  }
  if (skylineFade.w == 0.0)
  {
    float depth = skylineFade.y;
    return depth > 0.0 ? skylineFade.x * (1.0 - clamp((shadows.y - z) / depth, 0.0, 1.0)) : 0.0;
  }
  if (!(z > shadows.x))
  {
    return 0.0;
  }
  float between = (z - shadows.x) / (shadows.y - shadows.x);
  float edge = atan(mix(skylineDisc.z, skylineDisc.w, between));
  float t = clamp((edge - skylineDisc.x) * skylineDisc.y, -1.0, 1.0);
  return (acos(t) - t * sqrt((1.0 - t) * (1.0 + t))) / SkylinePi;
}

vec3 SkylineIrradiance(vec2 post)
{
  vec3 n = SkylineNormal();
  vec3 light = skylineSky[0].rgb + n.y * skylineSky[1].rgb + n.z * skylineSky[2].rgb +
    n.x * skylineSky[3].rgb + n.x * n.y * skylineSky[4].rgb + n.y * n.z * skylineSky[5].rgb +
    (3.0 * n.z * n.z - 1.0) * skylineSky[6].rgb + n.x * n.z * skylineSky[7].rgb +
    (n.x * n.x - n.y * n.y) * skylineSky[8].rgb;
  light = max(light, 0.0);
  float cosine = dot(n, skylineSunDirection);
  if (cosine > 0.0)
  {
    light += cosine * SkylineLit(post, skylineWorldVSOutput.z) * skylineSun;
  }
  return light;
}
//Skyline::Points
in vec3 skylineNormalVSOutput;
