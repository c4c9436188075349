// SPDX-License-Identifier: BSD-3-Clause
// Heights that may stand for missing posts: counted as they pass, judged in the end.
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

/// Remembers the lowest and the highest values of a raster with their numbers of posts. Rasters often
/// mark posts without a height by a value such as -9999 and do not say so.
///
/// Judged doubtful is
/// - a value that programs use for missing posts (FillValue) and that lies apart from the rest by a
///   tenth of the rest's range, or stands at far more posts than its neighbours do;
/// - any value that lies further from all others than any ground does (FarApart), or below all others
///   of a varied terrain by 1000 m and half its range, at few posts;
/// - 0, where the rest of a varied terrain lies at least 50 m and a tenth of its range away from it, or,
///   for fewer than half the posts, 10 m and twice its range.
/// Everything else is terrain: bathymetry that passes -9999, ground below sea level, a sea of 0 with a
/// coast.
class SKYLINECORE_EXPORT HeightCensus
{
public:
  /// Counts a height, finite, as the raster has it.
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
    double Lowest = 0.0, Highest = 0.0; ///< of the heights that are not doubted; raster's unit
    bool Any = false;                   ///< there are such heights
  };

  /// subject: whose posts, "'dem.tif'". metres: in one unit of the values, not 0. single: the values are
  /// 32-bit floats, which need fewer digits.
  Findings Judge(const std::string& subject, double metres, bool single) const;

  /// The shortest decimal number that reads as `value`, as a 32-bit float if `single`.
  static std::string Text(double value, bool single);

private:
  static constexpr std::size_t Kept = 8; ///< distinct values at each end
  static constexpr double LeastWatched = 9990.0;
  static constexpr std::array<double, 4> Watched{ { -9999.0, -32768.0, -32767.0, -99999.0 } };
  static constexpr double Near = 8.0; ///< values this near to a watched one are its neighbours

  struct Value
  {
    double Height = 0.0;
    std::int64_t Posts = 0;
  };

  /// Up to Kept distinct values, best first.
  struct End
  {
    std::array<Value, Kept> Values;
    std::size_t Size = 0;
    bool Note(double height, bool low); // true if it is kept
  };

  void Note(double height);

  /// Why the value end.Values[first] is doubtful, given the next one and the one at the far end; empty if it
  /// is not. fillsOnly: values that are merely far away are not looked at yet.
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
