// SPDX-License-Identifier: BSD-3-Clause
// The share of a disc that another disc covers, such as that of the sun behind the Moon.
#ifndef skyline_CoveredDisc_h
#define skyline_CoveredDisc_h

#include "SkylineCoreModule.h" // for the export macro

namespace skyline
{

/// The share of the light of a disc that another disc covers: 0 to 1, exactly 0 if they do not meet
/// and exactly 1 if nothing remains. Both discs are flat, which is accurate for small discs in the
/// sky (error 2e-5 for discs of 0.3 degrees).
///
/// `distance` of the centres and radius `cover` of the covering disc: in radii of the covered disc,
/// 0 or more. `limbDarkening`: u of the intensity 1 - u (1 - mu), 0 (default: a uniform disc,
/// closed form) to 1 (a sum of 48 rings, error 1e-5).
SKYLINECORE_EXPORT double CoveredShare(double distance, double cover, double limbDarkening = 0.0);

/// The covered part of the diameter through both centres, 0 or more, as in tables of eclipses. If
/// one disc lies entirely in front of or behind the other, the ratio of the diameters. The
/// arguments are those of CoveredShare.
SKYLINECORE_EXPORT double CoveredMagnitude(double distance, double cover);

} // namespace skyline

#endif
