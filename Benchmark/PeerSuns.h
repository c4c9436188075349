// SPDX-License-Identifier: BSD-3-Clause
// What other programs say of a sun's light, each run as its users run it.
#ifndef skyline_PeerSuns_h
#define skyline_PeerSuns_h

#include "External.h"
#include "Reference/Oracle.h"
#include "Stage.h"

#include <functional>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// The beam of a point sun on every post, row by row from the south: the cosine of its incidence, 0 in
/// shadow. Adds what the program took to the cost.
using PeerSun = std::function<std::vector<float>(const SunAt&, Cost&)>;

/// SAGA's ta_lighting 0, the hillshade with shadows; slopes by central differences, its own.
PeerSun SagaSun(const oracle::OracleField& field);

/// gdaldem hillshade with the slopes of Zevenbergen & Thorne, which are central differences too. It
/// casts no shadow, and its 254 shades round.
PeerSun GdalSun(const oracle::OracleField& field);

/// r.sunmask of GRASS, which knows lit (1) and dark (0) alone.
PeerSun GrassSunMask(const oracle::OracleField& field);

/// Beam irradiance of GRASS r.sun, mode 1, in parts of the extraterrestrial: linke_value=0 leaves no
/// atmosphere. The place is the equator, with the declination and the hour that put the sun there.
/// Given are slope and aspect of the very planes that the truth has.
PeerSun GrassSun(const oracle::OracleField& field);

/// The sky view factors that r.sun's diffuse light stands for, of every post, row by row from the south:
/// the sun at the zenith without a beam (coeff_bh 0), which leaves an all but uniform sky.
std::vector<float> GrassDiffuse(const oracle::OracleField& field, Cost& cost);

} // namespace benchmark
} // namespace skyline

#endif
