// SPDX-License-Identifier: BSD-3-Clause
// The parameters of the pyramid of Snyder & Nowrouzezahrai 2008 (SN08).
#ifndef skyline_PyramidSettings_h
#define skyline_PyramidSettings_h

namespace skyline
{

/// The defaults are those of SN08: k = 4 (section 7), lambda = 1 (section 4), o = 2 (figure 6).
struct PyramidSettings
{
  double LevelStep = 4.0;   ///< k: levels per octave, 1 to 16; more are smoother and slower
  double LevelOffset = 2.0; ///< o: octaves by which finer levels are read, 0 or more
  double Distance = 1.0;    ///< lambda: distance at which a level is read, in its samples; above 0
  /// Use the B-spline over log distance, as for key lights. If false, the greatest angle of all
  /// levels is taken, which is cheaper and good enough for environments (section 6).
  bool Spline = true;
};

} // namespace skyline

#endif
