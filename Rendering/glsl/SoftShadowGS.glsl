// SPDX-License-Identifier: BSD-3-Clause
// Passes on the texture coordinates if VTK draws edges or wide lines with a geometry shader.
in vec2 skylinePostVSOutput[];
out vec2 skylinePostGSOutput;
//Skyline::Impl
    skylinePostGSOutput = skylinePostVSOutput[i];
