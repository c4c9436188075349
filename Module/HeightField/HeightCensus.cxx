// SPDX-License-Identifier: BSD-3-Clause
#include "HeightField/HeightCensus.h"

#include "Shared/HeightLimits.h"

#include <algorithm>
#include <charconv>

namespace skyline
{

namespace
{

/// A gap in metres between a height and the next one that does not occur on any ground: the
/// greatest known relief of a solid body, such as the ridge of Iapetus and the basin of Vesta, is
/// about 20 km from foot to top.
constexpr double FarApart = 20000.0;

/// A relief in metres that no solid body has: Vesta, which has the greatest known, has 41 km.
constexpr double NoRelief = 1.0e5;

/// A gap, in metres and as a part of the range of a varied terrain, between the terrain and a lower
/// value. No terrain has such a gap without a slope in between; but programs mark missing posts by
/// various low values.
constexpr double FarBelow = 1000.0;
constexpr double FarBelowPart = 0.5;

/// Largest share of all posts for which a low value is doubted. A plain at the foot of cliffs has
/// more.
constexpr double FewPosts = 0.1;

/// Least gap between a FillValue and the other heights, as a part of their range.
constexpr double Apart = 0.1;
constexpr double LeastApart = 10.0; ///< metres

/// Least distance in metres of a terrain from 0 if posts of 0 are doubted. If it is less, 0 is a
/// real height, as on a plain with a cone.
constexpr double ClearOfZero = 50.0;

/// A few posts of 0 are also doubted if a flat terrain lies further away than this multiple of its
/// range.
constexpr double TwiceRange = 2.0;

/// Least number of posts of a fill value inside the range of heights. It must also exceed the
/// number of posts with similar heights.
constexpr std::int64_t ManyPosts = 16;

/// Largest number of warnings for one raster. More would not help the user.
constexpr std::size_t MostDoubts = 3;

/// 1e3, 1e4 and so on.
bool PowerOfTen(double value)
{
  constexpr std::array<double, 13> powers{ { 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12,
    1e13, 1e14, 1e15 } };
  return std::find(powers.begin(), powers.end(), value) != powers.end();
}

/// 999, 9999, 99999 and so on.
bool AllNines(double value)
{
  return PowerOfTen(value + 1.0);
}

/// Values that programs use for "no height": nines, negative powers of ten, the ends of integers.
bool FillValue(double value)
{
  constexpr std::array<double, 9> ends{ { -32768.0, -32767.0, 32767.0, 65535.0, -2147483648.0,
    -2147483647.0, 2147483647.0, 4294967295.0, -9223372036854775808.0 } };
  return AllNines(std::abs(value)) || (value <= -1e4 && PowerOfTen(-value)) ||
    std::find(ends.begin(), ends.end(), value) != ends.end();
}

const char* const OftenMissing = "which often stands for a missing post";

std::string Posts(std::int64_t count, const std::string& subject)
{
  return std::to_string(count) + (count == 1 ? " post of " : " posts of ") + subject +
    (count == 1 ? " has" : " have");
}

} // namespace

std::string HeightCensus::Text(double value, bool single)
{
  if (value == 0.0)
  {
    return "0"; // of either sign
  }
  std::array<char, 40> text{};
  char* const begin = text.data();
  char* const end = begin + text.size();
  const auto done = single ? std::to_chars(begin, end, static_cast<float>(value))
                           : std::to_chars(begin, end, value);
  return { begin, done.ptr };
}

bool HeightCensus::End::Note(double height, bool low)
{
  std::size_t place = 0;
  while (place < this->Size &&
    (low ? this->Values[place].Height < height : this->Values[place].Height > height))
  {
    ++place;
  }
  if (place < this->Size && this->Values[place].Height == height)
  {
    ++this->Values[place].Posts;
    return true;
  }
  if (place == EndSize)
  {
    return false;
  }
  this->Size = std::min(this->Size + 1, EndSize);
  for (std::size_t i = this->Size - 1; i > place; --i)
  {
    this->Values[i] = this->Values[i - 1];
  }
  this->Values[place] = { height, 1 };
  return true;
}

void HeightCensus::Note(double height)
{
  if (height <= this->LowLimit && this->Low.Note(height, true) && this->Low.Size == EndSize)
  {
    this->LowLimit = this->Low.Values[EndSize - 1].Height;
  }
  if (height >= this->HighLimit && this->High.Note(height, false) && this->High.Size == EndSize)
  {
    this->HighLimit = this->High.Values[EndSize - 1].Height;
  }
  if (std::abs(height) >= LeastWatched)
  {
    for (std::size_t i = 0; i < Watched.size(); ++i)
    {
      this->AtWatched[i] += height == Watched[i] ? 1 : 0;
      this->NearWatched[i] += height != Watched[i] && std::abs(height - Watched[i]) <= Near ? 1 : 0;
    }
  }
}

std::string HeightCensus::WhyDoubtful(
  const End& end, std::size_t first, double far, bool atLow, bool fillsOnly, double metres) const
{
  const Value& value = end.Values[first];
  const double next = end.Values[first + 1].Height;
  const double gap = std::abs(next - value.Height);
  const double range = std::abs(far - next);
  const bool clear = gap >= Apart * range;
  const bool varied =
    end.Size == EndSize && first + 2 < EndSize && end.Values[EndSize - 1].Height != far;
  const bool fill = clear && FillValue(value.Height) && gap * metres >= LeastApart &&
    (std::abs(value.Height) > 1000.0 || gap >= range);
  const bool minority = 2 * value.Posts < this->Count;
  const bool zero = clear && value.Height == 0.0 && varied &&
    (gap * metres >= ClearOfZero ||
      (minority && gap * metres >= LeastApart && gap >= TwiceRange * range));
  const bool pit = atLow && varied && value.Posts < FewPosts * this->Count &&
    gap * metres >= FarBelow && gap >= FarBelowPart * range;
  if (fill || zero || std::abs(value.Height) * metres > GreatestHeight)
  {
    return OftenMissing;
  }
  if (!fillsOnly && (pit || (gap * metres >= FarApart && gap >= range)))
  {
    return std::string("far ") + (atLow ? "below" : "above") + " all others (" +
      Text(std::min(next, far), true) + " to " + Text(std::max(next, far), true) + ")";
  }
  return {};
}

HeightCensus::Findings HeightCensus::Judge(
  const std::string& subject, double metres, bool single) const
{
  Findings findings;
  metres = std::abs(metres);
  const auto add = [&](const Value& value, const std::string& why)
  {
    const std::string text = Text(value.Height, single);
    const bool one = value.Posts == 1;
    const char* const use = std::abs(value.Height) * metres > GreatestHeight
      ? (one ? "this is a missing post" : "these are missing posts")
      : (one ? "this is a height" : "these are heights");
    findings.Doubts.push_back({ Posts(value.Posts, subject) + " the height " + text + ", " + why,
      use, "--nodata " + text });
  };
  const std::string missing = OftenMissing;

  // Judge from both ends inwards, as long as the value at an end is doubtful and others remain.
  std::size_t low = 0, high = 0;
  bool left = true;
  bool any = this->Count > 0;
  bool fillsOnly = true; // judged first, because the remaining values may then no longer be far
                         // apart
  std::vector<double> doubted;
  const auto judge = [&](const End& end, std::size_t& first, double far, bool atLow)
  {
    const Value& value = end.Values[first];
    std::string why;
    if (far == value.Height)
    {
      left = false;
      any = !FillValue(value.Height) && std::abs(value.Height) * metres <= GreatestHeight;
      why = any ? "" : missing;
    }
    else if (first + 1 < EndSize)
    {
      why = this->WhyDoubtful(end, first, far, atLow, fillsOnly, metres);
    }
    if (why.empty())
    {
      return false;
    }
    add(value, why);
    doubted.push_back(value.Height);
    ++first;
    return true;
  };
  const auto judgeEnds = [&]
  {
    return (left && judge(this->Low, low, this->High.Values[high].Height, true)) ||
      (left && judge(this->High, high, this->Low.Values[low].Height, false));
  };
  for (const bool fills : { true, false })
  {
    fillsOnly = fills;
    left = any;
    while (low < EndSize && high < EndSize && judgeEnds())
    {
    }
  }

  for (std::size_t i = 0; i < Watched.size(); ++i)
  {
    const bool told = std::find(doubted.begin(), doubted.end(), Watched[i]) != doubted.end();
    if (!told && this->AtWatched[i] >= ManyPosts && this->AtWatched[i] > this->NearWatched[i])
    {
      add({ Watched[i], this->AtWatched[i] }, missing);
    }
  }

  findings.Doubts.resize(std::min(findings.Doubts.size(), MostDoubts));
  findings.Lowest = this->Low.Values[std::min(low, EndSize - 1)].Height;
  findings.Highest = this->High.Values[std::min(high, EndSize - 1)].Height;
  findings.Any = any && findings.Lowest <= findings.Highest;
  if (findings.Any && findings.Doubts.empty() &&
    (findings.Highest - findings.Lowest) * metres > NoRelief)
  {
    findings.Doubts.push_back(
      { "the heights of " + subject + " reach from " + Text(findings.Lowest * metres, true) +
          " to " + Text(findings.Highest * metres, true) + " m, more than any body has",
        "they are heights in metres", "another unit (gdal_edit.py -units)" });
  }
  return findings;
}

} // namespace skyline
