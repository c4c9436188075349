// SPDX-License-Identifier: BSD-3-Clause
// The recurrence of Lee & Kim, section 3.1, equation 1 and its type 2, as in ShadowHeightSweep. A
// run processes some lines, in the direction away from the light. Each work group keeps its section
// of a line in shared memory.
// A lane needs the neighbour to its side on the previous line, so the valid section shrinks by one
// lane per line. Therefore the work groups overlap by as many lanes as a run has lines.
// passed: the shadow heights that arrive, without the post's own height.
layout(local_size_x = 256) in;
layout(r32f, binding = 0) uniform writeonly image2D passed; // by lane and line
layout(std430, binding = 0) readonly buffer Before { float before[]; }; // shadow heights by lane
layout(std430, binding = 1) writeonly buffer After { float after[]; };
uniform sampler2D heights;
uniform int columns;  // 1: lines are columns of the image
uniform int reversed; // 1: lines are counted from the far edge
uniform int drift;    // +1 or -1: the side of that neighbour
uniform ivec2 size;   // lanes and lines
uniform ivec2 lines;  // the first of this run, and one past the last; in descending order
uniform float aside;
uniform float fall;

const float Missing = -1.0e30;

shared float line[256];

ivec2 Place(int at, int lane)
{
  int row = reversed != 0 ? size.y - 1 - at : at;
  return columns != 0 ? ivec2(row, lane) : ivec2(lane, row);
}

void main()
{
  int own = int(gl_LocalInvocationID.x);
  int kept = 256 - (lines.x - lines.y);
  int order = int(gl_WorkGroupID.x) * kept + own;
  int lane = drift > 0 ? order : size.x - 1 - order;
  bool there = order < size.x;
  bool first = aside > 0.0 && order == size.x - 1;
  bool mine = there && own < kept;
  float height = Missing;
  if (there)
  {
    height = lines.x == size.y - 1 ? texelFetch(heights, Place(lines.x, lane), 0).x : before[lane];
    if (mine && lines.x == size.y - 1)
    {
      imageStore(passed, ivec2(lane, lines.x), vec4(Missing));
    }
  }
  line[own] = height;
  barrier();
  for (int at = lines.x - 1; at >= lines.y; --at)
  {
    float neighbour = own < 255 ? line[own + 1] : Missing;
    float reached = first ? Missing : (1.0 - aside) * height + aside * neighbour - fall;
    if (there)
    {
      height = max(texelFetch(heights, Place(at, lane), 0).x, reached);
    }
    if (mine)
    {
      imageStore(passed, ivec2(lane, at), vec4(reached));
    }
    barrier();
    line[own] = height;
    barrier();
  }
  if (mine)
  {
    after[lane] = height;
  }
}
