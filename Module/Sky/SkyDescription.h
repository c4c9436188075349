// SPDX-License-Identifier: BSD-3-Clause
// Which sky shines, and how users write it: on the command line, in the window, in Python.
#ifndef skyline_SkyDescription_h
#define skyline_SkyDescription_h

#include "SkylineCoreModule.h" // for the export macro

#include <string>

namespace skyline
{

/// The kinds of skies that are computed differently.
enum class SkyKind
{
  None,    ///< black
  Uniform, ///< equally bright everywhere
  Zonal,   ///< a CIE sky that is the same all around
  Formula, ///< another CIE sky: brighter about the sun
  Perez,   ///< Perez's all-weather sky, with its sun
  Map      ///< a light map
};

/// A sky.
struct SkyDescription
{
  SkyKind Kind = SkyKind::Uniform;
  int CieType = 0;                                        ///< of Zonal and Formula: 1 to 16
  double DirectIrradiance = 0.0, DiffuseIrradiance = 0.0; ///< of Perez, W/m2
  std::string Text = "uniform"; ///< as it is written; of a Map: the file's name

  /// Whether it looks the same in all azimuths.
  bool SameAllAround() const { return this->Kind <= SkyKind::Zonal; }

  /// Whether it is as bright as it is, and not scaled for a picture.
  bool Measured() const { return this->Kind >= SkyKind::Perez; }
};

/// The sky of a light map's file.
SKYLINECORE_EXPORT SkyDescription SkyOfFile(const std::string& file);

/// Reads "uniform"; "cie:N", N from 1 to 16; "perez:DIRECT,DIFFUSE" in W/m2; with `takesNone` also "none".
/// Any other text is the name of a light map's file, which is not opened. Throws std::invalid_argument,
/// naming text and cure, for a number out of range, and for a word without a point or slash that no file
/// has as its name.
SKYLINECORE_EXPORT SkyDescription ParseSky(const std::string& text, bool takesNone = false);

} // namespace skyline

#endif
