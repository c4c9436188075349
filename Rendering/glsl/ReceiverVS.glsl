// SPDX-License-Identifier: BSD-3-Clause
// The position of a vertex in metres: rows of an affine map of (x, y, z, 1) in the vertex buffer.
// The parts Points and PointsImpl are for meshes with normals.
uniform vec4 skylineWorldX;
uniform vec4 skylineWorldY;
uniform vec4 skylineWorldZ;
out vec3 skylineWorldVSOutput;
//Skyline::Impl
  skylineWorldVSOutput = vec3(dot(skylineWorldX, skylineVertex),
    dot(skylineWorldY, skylineVertex), dot(skylineWorldZ, skylineVertex));
//Skyline::Points
in vec3 normalMC;
uniform mat3 skylineNormalMatrix;
out vec3 skylineNormalVSOutput;
//Skyline::PointsImpl
  skylineNormalVSOutput = skylineNormalMatrix * normalMC;
