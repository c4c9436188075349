// SPDX-License-Identifier: BSD-3-Clause
// State of the exact horizon: convex bounds over segments of lines. Design: Documentation/horizon.md.
#ifndef skyline_HorizonExact_h
#define skyline_HorizonExact_h

#include "Horizon/HorizonMethod.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace skyline
{

/// For every segment of lines and every lane by which a ray can enter it, two supports of the posts
/// that the ray can touch: the greatest height h, and the greatest h - T e, where e counts lines from
/// the segment's near edge and T is the support slope. The greatest h - g e is convex in g, so the
/// chord between both bounds it for g in 0 .. T; above T the second does; below 0 the first does
/// with |g| x length added.
struct SegmentBounds
{
  static constexpr std::ptrdiff_t Lines = 16;   ///< lines of a segment
  static constexpr std::ptrdiff_t PerGroup = 8; ///< segments of a group, which has bounds too

  void Resize(std::ptrdiff_t lines, std::ptrdiff_t stride, std::ptrdiff_t margin);

  float* Level(std::ptrdiff_t segment) { return this->At(2 * segment); }
  float* Tilted(std::ptrdiff_t segment) { return this->At(2 * segment + 1); }
  float* GroupLevel(std::ptrdiff_t group) { return this->At(2 * (this->Segments + group)); }
  float* GroupTilted(std::ptrdiff_t group) { return this->At(2 * (this->Segments + group) + 1); }
  const float* Level(std::ptrdiff_t s) const { return const_cast<SegmentBounds*>(this)->Level(s); }
  const float* Tilted(std::ptrdiff_t s) const
  {
    return const_cast<SegmentBounds*>(this)->Tilted(s);
  }
  const float* GroupLevel(std::ptrdiff_t g) const
  {
    return const_cast<SegmentBounds*>(this)->GroupLevel(g);
  }
  const float* GroupTilted(std::ptrdiff_t g) const
  {
    return const_cast<SegmentBounds*>(this)->GroupTilted(g);
  }

  std::ptrdiff_t Segments = 0;
  std::ptrdiff_t Groups = 0;

private:
  float* At(std::ptrdiff_t line)
  {
    return this->Values.data() + line * this->Stride + this->Margin;
  }
  std::ptrdiff_t Stride = 0, Margin = 0;
  std::vector<float> Values;
};

/// Lanes of posts, from a ray's entry lane, that rays of the lane can touch on a line of a segment.
struct SegmentReach
{
  std::ptrdiff_t First, Last;
};

/// Which segments hold missing posts, by runs of lanes; empty for a field without any.
class SegmentHoles
{
public:
  void Resize(const MissingMap& posts);
  bool Empty() const { return this->Missing.empty(); }

  /// The flags of the segments of a group.
  void Build(const RayFrame& frame, const MissingMap& posts, std::ptrdiff_t group);

  /// True if a post may be missing in lanes begin .. end of the segment or on the line before it,
  /// whose cells share the segment's first edges. Lanes outside the data hold none.
  bool Any(std::ptrdiff_t segment, std::ptrdiff_t begin, std::ptrdiff_t end) const
  {
    const std::uint8_t* runs = this->Missing.data() + segment * this->Runs;
    const std::ptrdiff_t last = std::min(end / MissingMap::RunLanes, this->Runs - 1);
    bool any = false;
    for (std::ptrdiff_t run = std::max<std::ptrdiff_t>(begin, 0) / MissingMap::RunLanes;
         run <= last; ++run)
    {
      any |= runs[run] != 0;
    }
    return any;
  }

private:
  std::ptrdiff_t Runs = 0;
  std::vector<std::uint8_t> Missing;
};

/// The segments that won for a block of receivers, which the next line tries first.
struct SegmentHints
{
  std::array<std::int32_t, 4> Segments{ { -1, -1, -1, -1 } };
  void Add(std::int32_t segment)
  {
    this->Segments = { { segment, this->Segments[0], this->Segments[1], this->Segments[2] } };
  }
};

/// Everything about an azimuth that the search reads.
struct ExactState
{
  static constexpr std::ptrdiff_t NearLines = 16;   ///< lines walked without asking the bounds
  static constexpr std::ptrdiff_t BoundMargin = 36; ///< lanes of bounds on either side of the data

  void Set(const RayFrame& frame, bool corners, double tolerance, float largestHeight);

  /// Lane by which the ray of a receiver enters the line `from` lines ahead, from its own lane.
  std::ptrdiff_t EntryLane(std::ptrdiff_t from) const
  {
    const std::ptrdiff_t whole = this->Frame->DriftAfter(from);
    return this->Frame->Drift > 0 ? whole : -whole - 1;
  }
  /// Metres that a post `from` lines ahead sinks.
  float SinkAt(std::ptrdiff_t from) const
  {
    return this->Frame->SinkPerLine2 * static_cast<float>(from) * static_cast<float>(from);
  }

  /// Lanes of bounds that receivers ask for, on a segment or group whose near edge is line `near`.
  /// Empty where all of them stand beyond it. `lines`: from there to the last line that the bounds hold.
  struct LaneRange
  {
    std::ptrdiff_t Begin, End;
  };
  LaneRange LanesAt(std::ptrdiff_t near, std::ptrdiff_t lines) const;

  const RayFrame* Frame = nullptr;
  std::ptrdiff_t LineBegin = 0, LineEnd = 0, LaneBegin = 0, LaneEnd = 0; ///< the receivers
  SegmentBounds Bounds;
  SegmentHoles Holes;
  std::array<SegmentReach, SegmentBounds::Lines + 1> Reach{};
  float Support = 0.0f, SupportInverse = 0.0f; ///< metres per line of the tilted support
  float TolerancePerLine = 0.0f;
  float Rounding = 0.0f; ///< metres: a bound closer than this to the horizon is rounding
  float LinesPerMetre = 1.0f;
};

class HorizonExact : public HorizonMethod
{
public:
  HorizonExact(const HeightField& field, const HorizonSettings& settings);

  void SetAzimuth(const Grid& grid, double azimuth) override;
  void SetReceivers(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd) override;
  std::ptrdiff_t PrepareCount() const override;
  void Prepare(std::ptrdiff_t begin, std::ptrdiff_t end) override;
  void Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd, float* slopes, std::ptrdiff_t stride) const override;

private:
  const HeightField& Field;
  HorizonSettings Settings;
  ExactState State;
};

} // namespace skyline

#endif
