// SPDX-License-Identifier: BSD-3-Clause
// The position of a vertex in the textures of the height field: rows of an affine map of (x, y, z,
// 1) in the vertex buffer to texture coordinates. The part Impl contains the lines of main.
uniform vec4 skylineAcross;
uniform vec4 skylineUp;
out vec2 skylinePostVSOutput;
//Skyline::Impl
  vec4 skylineVertex = vec4(vertexMC.xyz, 1.0);
  skylinePostVSOutput = vec2(dot(skylineAcross, skylineVertex), dot(skylineUp, skylineVertex));
