// SPDX-License-Identifier: BSD-3-Clause
// Describes a sky, in the notation of the command line, the window and Python.
#ifndef skyline_SkyDescription_h
#define skyline_SkyDescription_h

#include "SkylineCoreModule.h" // for the export macro

#include <string>

namespace skyline
{

/// Kinds of skies, by how they are computed.
enum class SkyKind
{
  None,    ///< black
  Uniform, ///< equally bright everywhere
  Zonal,   ///< a CIE sky with the same radiance in all azimuths
  Formula, ///< another CIE sky, which is brighter around the sun
  Perez,   ///< the all-weather sky of Perez, with its sun
  Map      ///< a light map
};

/// A sky.
struct SkyDescription
{
  SkyKind Kind = SkyKind::Uniform;
  int CieType = 0;                                        ///< for Zonal and Formula: 1 to 16
  double DirectIrradiance = 0.0, DiffuseIrradiance = 0.0; ///< for Perez, W/m2
  std::string Text = "uniform"; ///< as the user wrote it; for Map the file name

  /// Returns true if the sky looks the same in all azimuths.
  bool SameAllAround() const { return this->Kind <= SkyKind::Zonal; }

  /// Returns true if the sky has absolute radiances, which a picture must not scale.
  bool Measured() const { return this->Kind >= SkyKind::Perez; }
};

/// The sky of a light map in a file.
SKYLINECORE_EXPORT SkyDescription SkyOfFile(const std::string& file);

/// Reads "uniform"; "cie:N" with N from 1 to 16; "perez:DIRECT,DIFFUSE" in W/m2; and, with
/// `takesNone`, "none". Any other text is the name of a light map file, which is not opened. Throws
/// std::invalid_argument, which names the text and a valid alternative, for a number out of range,
/// and for a text without point or slash that is not the name of an existing file.
SKYLINECORE_EXPORT SkyDescription ParseSky(const std::string& text, bool takesNone = false);

} // namespace skyline

#endif
