// SPDX-License-Identifier: BSD-3-Clause
// Horizons kept between executions, so that changed light needs no new ones.
#ifndef skyline_HorizonCache_h
#define skyline_HorizonCache_h

#include <map>
#include <vector>

namespace skyline
{

class Accumulator;
class HorizonDriver;

/// Runs consumers over azimuths. If it keeps horizons, only azimuths that it has not met are searched;
/// a kept azimuth costs a float a post.
class HorizonCache
{
public:
  bool Keep = false;

  /// Azimuths searched by Run since this was last set to 0.
  int Searched = 0;

  /// Forgets all horizons unless they belong to the same surface: any numbers that name it.
  void SetSurface(const std::vector<double>& key);

  /// As HorizonDriver::Run.
  bool Run(HorizonDriver& driver, const std::vector<double>& azimuths, double width,
    Accumulator& consumer);

private:
  std::vector<double> Key;
  std::map<double, std::vector<float>> Slopes; // by azimuth, radians
};

} // namespace skyline

#endif
