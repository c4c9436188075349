// SPDX-License-Identifier: BSD-3-Clause
// Keeps horizons between executions, so that changed lights need no new search.
#ifndef skyline_HorizonCache_h
#define skyline_HorizonCache_h

#include <map>
#include <vector>

namespace skyline
{

class Accumulator;
class HorizonDriver;

/// Runs consumers over azimuths. With Keep, only azimuths that were not searched before are
/// searched; each azimuth that is kept takes one float per post.
class HorizonCache
{
public:
  bool Keep = false;

  /// Azimuths searched by Run since this was last set to 0.
  int Searched = 0;

  /// Discards all horizons unless `key` is the same as before. The key is any list of numbers that
  /// identifies the surface.
  void SetSurface(const std::vector<double>& key);

  /// The same as HorizonDriver::Run, with the horizons that are kept.
  bool Run(HorizonDriver& driver, const std::vector<double>& azimuths, double width,
    Accumulator& consumer);

private:
  std::vector<double> Key;
  std::map<double, std::vector<float>> Slopes; // by azimuth, radians
};

} // namespace skyline

#endif
