// SPDX-License-Identifier: BSD-3-Clause
// Finds heights that may mark missing posts: counts heights while they are read and judges them at
// the end.
#ifndef skyline_HeightCensus_h
#define skyline_HeightCensus_h

#include "Shared/Doubt.h"
#include "SkylineCoreModule.h" // for the export macro

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace skyline
{

/// Keeps the lowest and the highest values of a raster with their numbers of posts. Rasters often
/// mark posts without a height by a value such as -9999 without declaring it.
///
/// These values are judged doubtful:
/// - a value that programs use for missing posts (FillValue), if it lies apart from the rest by a
///   tenth of the range of the rest, or if many posts have it and fewer have similar heights;
/// - any value that lies further from all others than on any ground (FarApart), or that lies below
///   a varied terrain by 1000 m and half the range of that terrain, at few posts;
/// - 0, if the rest is a varied terrain that lies at least 50 m and a tenth of its range away from
///   it, or, for fewer than half of the posts, 10 m and twice its range.
/// Everything else counts as terrain: bathymetry that reaches below -9999, ground below sea level,
/// a sea of 0 with a coast.
class SKYLINECORE_EXPORT HeightCensus
{
public:
  /// Counts a height, which must be finite, in the unit of the raster.
  void Add(double height)
  {
    ++this->Count;
    if (height <= this->LowLimit || height >= this->HighLimit || std::abs(height) >= LeastWatched)
    {
      this->Note(height);
    }
  }

  struct Findings
  {
    std::vector<Doubt> Doubts;
    double Lowest = 0.0, Highest = 0.0; ///< of the heights that are not doubted, in the unit of the
                                        ///< raster
    bool Any = false;                   ///< true if there are such heights
  };

  /// Returns what was found. subject: the raster in the messages, such as "'dem.tif'". metres:
  /// metres per unit of the values, not 0. single: true if the values are 32-bit floats, which need
  /// fewer digits.
  Findings Judge(const std::string& subject, double metres, bool single) const;

  /// The shortest decimal number that is read as `value`, as a 32-bit float if `single`.
  static std::string Text(double value, bool single);

private:
  static constexpr std::size_t EndSize = 8; ///< distinct values at each end
  static constexpr double LeastWatched = 9990.0;
  static constexpr std::array<double, 4> Watched{ { -9999.0, -32768.0, -32767.0, -99999.0 } };
  static constexpr double Near = 8.0; ///< values that differ from a watched one by at most this are
                                      ///< similar

  struct Value
  {
    double Height = 0.0;
    std::int64_t Posts = 0;
  };

  /// Up to EndSize distinct values, starting with the most extreme.
  struct End
  {
    std::array<Value, EndSize> Values;
    std::size_t Size = 0;
    bool Note(double height, bool low); // returns true if the height is kept
  };

  void Note(double height);

  /// The reason why the value end.Values[first] is doubtful, given the next value and the one at
  /// the opposite end; empty if it is not. fillsOnly: do not yet consider values that are only far
  /// away.
  std::string WhyDoubtful(
    const End& end, std::size_t first, double far, bool atLow, bool fillsOnly, double metres) const;

  std::int64_t Count = 0;
  End Low, High;
  double LowLimit = std::numeric_limits<double>::infinity();
  double HighLimit = -std::numeric_limits<double>::infinity();
  std::array<std::int64_t, Watched.size()> AtWatched{}, NearWatched{};
};

} // namespace skyline

#endif
