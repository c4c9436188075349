// SPDX-License-Identifier: BSD-3-Clause
// How much of a disc another disc covers: the sun behind the Moon.
#ifndef skyline_CoveredDisc_h
#define skyline_CoveredDisc_h

#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// The share of a disc's light that another disc covers: 0 to 1, exactly 0 where they do not meet and
/// exactly 1 where nothing is left. Both are flat, as small discs in the sky are (discs of 0.3 degrees:
/// 2e-5).
///
/// `distance` of the centres and `cover`, the covering disc's radius: in radii of the covered disc, 0 or
/// more. `limbDarkening`: u of the intensity 1 - u (1 - mu), 0 (default: an even disc, closed form) to 1
/// (a sum of 48 rings: 1e-5).
SKYLINECORE_EXPORT double CoveredShare(double distance, double cover, double limbDarkening = 0.0);

/// The covered part of the diameter through both centres, 0 or more, as tables of eclipses give it:
/// where one disc lies wholly upon the other, the ratio of the diameters. Both arguments as CoveredShare
/// takes them, in radii of the covered disc.
SKYLINECORE_EXPORT double CoveredMagnitude(double distance, double cover);

} // namespace skyline

#endif
