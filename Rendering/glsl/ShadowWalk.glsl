// SPDX-License-Identifier: BSD-3-Clause
// Shadow heights from each edge that a ray crosses: the walk of GpuExact.glsl, with weights whose
// sum is 1 and with the fall of the light in place of the drop. The text of GpuExact.glsl precedes
// this text.
uniform ivec2 area; // the first post
void main()
{
  own = 0.0; // heights are absolute, not relative to the receiver
  float height = Horizon(area + ivec2(gl_FragCoord.xy));
  gl_FragData[0] = vec4(height < NoEdge ? Missing : height) * min(1.0, texCoord.x + 2.0);
}
