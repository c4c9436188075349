// SPDX-License-Identifier: BSD-3-Clause
// E = T . L: the product of the transfer coefficients of a post, four per image, and those of a
// light.
// light: for each image one vector each of red, of green and of blue.
uniform vec4 light[48];
//Fill::Images

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec3 sum = vec3(0.0);
  //Fill::Sum
  gl_FragData[0] = vec4(max(sum, 0.0), min(1.0, texCoord.x + 2.0));
}
