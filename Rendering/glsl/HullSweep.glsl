// SPDX-License-Identifier: BSD-3-Clause
// The line sweep of Timonen & Westerholm (2010), sections 4 and 5, as in HorizonSweep. Each
// invocation follows one line. Its samples are one post apart and start at the far end. A buffer
// holds the convex hull of the samples that were passed; the top of the hull is in registers.
// Positions are in double precision, so that samples on long lines are placed exactly. C++ defines
// NoTerrain.
layout(local_size_x = 64) in;
layout(r32f, binding = 0) uniform writeonly image2D slopes; // by sample and by line of this run
layout(std430, binding = 0) buffer Hull { vec2 hull[]; };   // number of the sample, and its height
uniform sampler2D heights;
uniform ivec2 posts;
uniform ivec2 lines; // the first of this run, and one past the last
uniform int samples;
uniform dvec2 origin;    // position of sample 0 of line 0, posts
uniform dvec2 perSample; // offset to the next sample, posts
uniform dvec2 perLine;   // offset to the next line, posts
uniform double begin;    // distance of sample 0 in the azimuth, metres
uniform double spacing;  // distance between samples, metres
uniform double drop;

const float Missing = -1.0e30;

float SlopeBetween(vec2 from, vec2 to)
{
  return (to.y - from.y) / ((to.x - from.x) * float(spacing));
}

// The bilinear height; Missing outside the data and in incomplete cells.
float HeightAt(dvec2 place)
{
  dvec2 whole = floor(place);
  if (whole.x < 0.0 || whole.y < 0.0 || place.x > double(posts.x - 1) ||
    place.y > double(posts.y - 1))
  {
    return Missing;
  }
  ivec2 at = ivec2(whole);
  vec2 part = vec2(place - whole);
  int right = part.x > 0.0 ? 1 : 0;
  int up = part.y > 0.0 ? 1 : 0;
  float a = texelFetch(heights, at, 0).x;
  float b = texelFetch(heights, at + ivec2(right, 0), 0).x;
  float c = texelFetch(heights, at + ivec2(0, up), 0).x;
  float d = texelFetch(heights, at + ivec2(right, up), 0).x;
  bool complete = min(min(a, b), min(c, d)) > 0.5 * Missing;
  return complete ? mix(mix(a, b, part.x), mix(c, d, part.x), part.y) : Missing;
}

void main()
{
  int own = int(gl_GlobalInvocationID.x);
  int line = lines.x + own;
  if (line >= lines.y)
  {
    return;
  }
  dvec2 start = origin + double(line) * perLine;
  int base = own * samples;
  int depth = 0;
  vec2 top = vec2(0.0);
  vec2 under = vec2(0.0);
  for (int index = samples - 1; index >= 0; --index)
  {
    float height = HeightAt(start + double(index) * perSample);
    float slope = uintBitsToFloat(0x7fc00000u); // NaN
    if (height > 0.5 * Missing)
    {
      double place = begin + double(index) * spacing;
      vec2 point = vec2(index, float(double(height) - drop * place * place));
      while (depth >= 2 && SlopeBetween(point, top) <= SlopeBetween(point, under))
      {
        --depth;
        top = under;
        under = depth >= 2 ? hull[base + depth - 2] : under;
      }
      slope = depth == 0 ? NoTerrain : SlopeBetween(point, top) + float(2.0 * drop * place);
      hull[base + depth] = point;
      ++depth;
      under = top;
      top = point;
    }
    imageStore(slopes, ivec2(index, own), vec4(slope));
  }
}
