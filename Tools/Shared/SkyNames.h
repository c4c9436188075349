// SPDX-License-Identifier: BSD-3-Clause
// The texts that --environment takes: the names of skies, and the files of light maps.
#ifndef skyline_SkyNames_h
#define skyline_SkyNames_h

#include <string>

namespace skyline
{

/// The sky of a name.
enum class SkyKind
{
  None,    ///< "none": black
  Uniform, ///< "uniform", or no name
  Zonal,   ///< a CIE sky that is the same all around
  Formula, ///< another CIE sky: brighter about the sun
  Perez,   ///< "perez:DIRECT,DIFFUSE", with its sun
  Map      ///< the file of a light map
};
SkyKind KindOfSky(const std::string& name);

/// Whether the sky is as bright as it is, not scaled for a picture.
bool IsMeasured(SkyKind kind);

/// Whether the name is that of a CIE sky, and its number: 1 to 16.
bool CieType(const std::string& name, int& type);

/// The two numbers of a Perez sky, W/m2; false for another name.
bool PerezIrradiances(const std::string& name, double& direct, double& diffuse);

///@{
/// What is wrong with the text of an --environment; empty: nothing, or a file, which is met later. A
/// word without a point or slash that no file has is no file. CheckSky takes "none" too.
std::string CheckEnvironment(const std::string& name);
std::string CheckSky(const std::string& name);
///@}

} // namespace skyline

#endif
