// SPDX-License-Identifier: BSD-3-Clause
// Shadow heights from every edge that a ray meets: the walk of GpuExact.glsl, whose weights then sum
// to 1 and whose sinks are the falls of the light. It comes before this text.
uniform ivec2 area; // the first post
void main()
{
  own = 0.0; // heights, not heights above the receiver
  float height = Horizon(area + ivec2(gl_FragCoord.xy));
  gl_FragData[0] = vec4(height < NoEdge ? Missing : height) * min(1.0, texCoord.x + 2.0);
}
