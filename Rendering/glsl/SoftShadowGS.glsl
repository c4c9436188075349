// SPDX-License-Identifier: BSD-3-Clause
// Hands the place in the textures on, where VTK draws edges and wide lines by a geometry shader.
in vec2 skylinePostVSOutput[];
out vec2 skylinePostGSOutput;
//Skyline::Impl
    skylinePostGSOutput = skylinePostVSOutput[i];
