// SPDX-License-Identifier: BSD-3-Clause
// The shader files of glsl/ as text, and their parts.
#ifndef skyline_ShaderText_h
#define skyline_ShaderText_h

#include <string>

// The text of the files. vtk_encode_string compiles them into the library under these names.
extern const char* skyline_HullSweep;
extern const char* skyline_Irradiance;
extern const char* skyline_Lamps;
extern const char* skyline_Receiver;
extern const char* skyline_ReceiverGS;
extern const char* skyline_ReceiverVS;
extern const char* skyline_ShadowSweep;
extern const char* skyline_ShadowWalk;
extern const char* skyline_SoftShadowFS;
extern const char* skyline_SoftShadowGS;
extern const char* skyline_SoftShadowVS;
extern const char* skyline_Srgb;
extern const char* skyline_ToneMap;
extern const char* skyline_Transfer;
extern const char* skyline_GpuAngles;
extern const char* skyline_GpuDecimate;
extern const char* skyline_GpuExact;
extern const char* skyline_GpuLight;
extern const char* skyline_GpuPyramid;
extern const char* skyline_GpuSpline;
extern const char* skyline_GpuWedges;
extern const char* skyline_Visibility;

namespace skyline
{

// Returns one part of a file: the lines after `//Skyline::Part` up to the next line that begins
// with `//Skyline::`, or, if the name is empty, the lines before the first of them.
// Placeholders that C++ replaces are written `//Fill::Name`. This function replaces `//Fill::Pi`
// and `//Fill::AngleTerms` by the numbers of Constants.h. All other lines with only a comment are
// removed, so that a search in the text of a shader finds code alone.
std::string ShaderPart(const char* file, const std::string& part = std::string());

} // namespace skyline

#endif
