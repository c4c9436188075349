// SPDX-License-Identifier: BSD-3-Clause
// Passes on the outputs of the vertex shader if VTK draws edges or wide lines with a geometry
// shader.
in vec3 skylineWorldVSOutput[];
out vec3 skylineWorldGSOutput;
//Skyline::Impl
    skylineWorldGSOutput = skylineWorldVSOutput[i];
//Skyline::Points
in vec3 skylineNormalVSOutput[];
out vec3 skylineNormalGSOutput;
//Skyline::PointsImpl
    skylineNormalGSOutput = skylineNormalVSOutput[i];
