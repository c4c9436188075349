// SPDX-License-Identifier: BSD-3-Clause
// Hands on what the vertex shader knows, where VTK draws edges and wide lines by a geometry shader.
in vec3 skylineWorldVSOutput[];
out vec3 skylineWorldGSOutput;
//Skyline::Impl
    skylineWorldGSOutput = skylineWorldVSOutput[i];
//Skyline::Points
in vec3 skylineNormalVSOutput[];
out vec3 skylineNormalGSOutput;
//Skyline::PointsImpl
    skylineNormalGSOutput = skylineNormalVSOutput[i];
