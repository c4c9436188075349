// SPDX-License-Identifier: BSD-3-Clause
// The shader files of glsl/ as text, and their parts.
#ifndef skyline_ShaderText_h
#define skyline_ShaderText_h

#include <string>

// The files, put into the library by vtk_encode_string under these names.
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

/// One part of a file: the lines after `//Skyline::Part` up to the next line that begins so, or,
/// with an empty name, those before the first. Places that C++ fills are `//Fill::Name`. All other
/// comment lines stay behind: a search in a shader's text finds code. `//Fill::Pi` and
/// `//Fill::AngleTerms` are filled here, with the numbers of Constants.h.
std::string ShaderPart(const char* file, const std::string& part = std::string());

} // namespace skyline

#endif
