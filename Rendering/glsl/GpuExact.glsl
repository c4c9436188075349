// SPDX-License-Identifier: BSD-3-Clause
// Horizons in one azimuth from each edge that a ray of a RayFrame crosses: the walk of
// RayWalk-inl.h, to the end of the data. Lines are rows or columns of the image, whichever the rays
// cross faster.
//
// heights: a rectangle of posts, whose edges are searched. receivers: the posts of the tile.
// steps: four texels per step, rowLength steps per row:
// 1. the lane of the trail post, 1 if the column of cells changes, the weights of trail and lead;
// 2. their drop, then near, far and drop between the lines;
// 3. the same on the left; 4. the same on the right.
uniform sampler2D heights;
uniform ivec2 place;     // column and row of the first post in heights
uniform ivec2 size;      // number of columns and rows in heights
uniform sampler2D receivers;
uniform sampler2D steps;
uniform ivec2 tile;      // first post of the tile
uniform int columns;     // 1: lines are columns
uniform int forward;     // +1 or -1: the order of lines
uniform int drift;       // +1 or -1: the direction in which lanes drift
uniform int against;     // 1: the diagonals run against the drift
uniform int first;       // the range of steps
uniform int last;
uniform float linesPerMetre;
uniform int channel;

const int RowLength = 1024;
const float Missing = -1.0e30;
const float NoEdge = -1.0e14; // metres per line: below every terrain

vec4 Step(int d, int part)
{
  return texelFetch(steps, ivec2(4 * (d % RowLength) + part, d / RowLength), 0);
}

float best;
float own; // the receiver's height

// The height of a post, relative to the receiver. The post lies some lines ahead and some lanes to
// the side.
float Post(ivec2 origin, int line, int lane)
{
  ivec2 at = origin + (columns != 0 ? ivec2(forward * line, lane) : ivec2(lane, forward * line));
  at -= place;
  bool there = at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y;
  return there ? texelFetch(heights, at, 0).x - own : Missing;
}

void Edge(bool counts, float weightA, float a, float weightB, float b, float drop)
{
  best = counts ? max(best, weightA * a + weightB * b - drop) : best;
}

bool Complete(float a, float b, float c, float d)
{
  return min(min(a, b), min(c, d)) > 0.5 * Missing;
}

// The search goes cell by cell. It meets an edge between two cells from both of them, so the edge
// counts if one of the two cells is complete.
float Horizon(ivec2 post)
{
  best = Missing;
  vec4 before = Step(first - 1, 0);
  float dropBefore = Step(first - 1, 1).x;
  float trailBefore = Post(post, first - 1, int(before.x));
  float leadBefore = Post(post, first - 1, int(before.x) + drift);
  // Lines beyond the rectangle are skipped.
  ivec2 from = post - place;
  int line = columns != 0 ? from.x : from.y;
  int lines = columns != 0 ? size.x : size.y;
  int end = min(last, forward > 0 ? lines - 1 - line : line);
  for (int d = first; d <= end; ++d)
  {
    vec4 row = Step(d, 0);
    vec4 mid = Step(d, 1); // their drop, near, far and drop between the lines
    int lane = int(row.x);
    float trail = Post(post, d, lane);
    float lead = Post(post, d, lane + drift);
    if (row.y == 0.0)
    {
      bool complete = Complete(trailBefore, leadBefore, trail, lead);
      Edge(complete && d > 1, before.z, trailBefore, before.w, leadBefore, dropBefore);
      Edge(complete, row.z, trail, row.w, lead, mid.x);
      Edge(complete, mid.y, against != 0 ? leadBefore : trailBefore, mid.z,
        against != 0 ? trail : lead, mid.w);
    }
    else
    {
      float left = Post(post, d, lane - drift);
      float right = Post(post, d - 1, int(before.x) + 2 * drift);
      bool leftComplete = Complete(trailBefore, leadBefore, left, trail);
      bool rightComplete = Complete(leadBefore, right, trail, lead);
      Edge(leftComplete && d > 1, before.z, trailBefore, before.w, leadBefore, dropBefore);
      Edge(leftComplete || rightComplete, mid.y, leadBefore, mid.z, trail, mid.w);
      Edge(rightComplete, row.z, trail, row.w, lead, mid.x);
      if (against != 0)
      {
        vec4 side = Step(d, 2);
        Edge(leftComplete, side.x, leadBefore, side.y, left, side.z);
        side = Step(d, 3);
        Edge(rightComplete, side.x, right, side.y, trail, side.z);
      }
    }
    if (row.w == 0.0)
    {
      // A post that occludes is the corner of a complete cell.
      Edge(trail > 0.5 * Missing, row.z, trail, 0.0, trail, mid.x);
    }
    before = row;
    dropBefore = mid.x;
    trailBefore = trail;
    leadBefore = lead;
  }
  return best;
}

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  own = texelFetch(receivers, at, 0).x;
  float slope = own > 0.5 * Missing ? Horizon(at + tile) : Missing;
  slope = slope < NoEdge ? -1.0e18 : slope * linesPerMetre;
  vec4 angles = vec4(-2.0 * RightAngle); // below all horizons: leaves the other azimuths unchanged
  angles[channel] = AngleOf(vec4(slope)).x;
  gl_FragData[0] = angles * min(1.0, texCoord.x + 2.0);
}
