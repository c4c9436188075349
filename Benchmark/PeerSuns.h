// SPDX-License-Identifier: BSD-3-Clause
// The light of a sun according to other programs, each run as its users run it.
#ifndef skyline_PeerSuns_h
#define skyline_PeerSuns_h

#include "External.h"
#include "Reference/Oracle.h"
#include "ReferenceScene.h"

#include <functional>
#include <vector>

namespace skyline
{
namespace benchmark
{

/// Returns the beam of a point sun at each post, row by row from the south: the cosine of the angle
/// of incidence, 0 in shadow. Adds the resources that the program used to the cost.
using PeerSun = std::function<std::vector<float>(const SunAt&, Cost&)>;

/// The hillshade with shadows of SAGA (ta_lighting 0), with SAGA's own slopes from central
/// differences.
PeerSun SagaSun(const oracle::OracleField& field);

/// The hillshade of gdaldem with the slopes of Zevenbergen & Thorne, which are central differences
/// too. It casts no shadows, and is rounded to 254 shades.
PeerSun GdalSun(const oracle::OracleField& field);

/// r.sunmask of GRASS, which only distinguishes lit (1) and dark (0).
PeerSun GrassSunMask(const oracle::OracleField& field);

/// The beam irradiance of GRASS r.sun, mode 1, as a fraction of the extraterrestrial one;
/// linke_value=0 means no atmosphere. The place is on the equator, and declination and hour are
/// those that put the sun in the wanted direction. Slope and aspect are those of the reference's
/// planes.
PeerSun GrassSun(const oracle::OracleField& field);

/// The sky view factors that the diffuse light of r.sun implies, for each post, row by row from the
/// south. The sun is at the zenith without a beam (coeff_bh 0), which gives an almost uniform sky.
std::vector<float> GrassDiffuse(const oracle::OracleField& field, Cost& cost);

} // namespace benchmark
} // namespace skyline

#endif
