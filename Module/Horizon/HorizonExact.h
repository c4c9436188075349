// SPDX-License-Identifier: BSD-3-Clause
// State of the exact search: convex bounds over segments of lines. Documentation/horizon.md
// explains it.
#ifndef skyline_HorizonExact_h
#define skyline_HorizonExact_h

#include "Horizon/HorizonMethod.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace skyline
{

/// Two supports of the posts that a ray can touch, for each segment of lines and each lane at which
/// the ray can enter the segment: the greatest height h, and the greatest h - T e, where e is the
/// number of lines from the near edge of the segment and T is the support slope. The greatest
/// h - g e is convex in g, so that the chord between both supports bounds it for g in 0 .. T. Above
/// T the second support bounds it. Below 0 the first support plus |g| x length does.
struct SegmentBounds
{
  static constexpr std::ptrdiff_t Lines = 16;   ///< lines per segment
  static constexpr std::ptrdiff_t PerGroup = 8; ///< segments per group; groups have bounds too

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

/// Range of lanes, relative to the entry lane, of the posts that rays can touch on a line of a
/// segment.
struct SegmentReach
{
  std::ptrdiff_t First, Last;
};

/// Marks the segments with missing posts, by runs of lanes. Empty if no post of the field is
/// missing.
class GapsInSegments
{
public:
  void Resize(const MissingMap& posts);
  bool Empty() const { return this->Missing.empty(); }

  /// Sets the flags of the segments of a group.
  void Build(const RayFrame& frame, const MissingMap& posts, std::ptrdiff_t group);

  /// Returns true if a post may be missing in lanes begin .. end of the segment, or on the line
  /// before it, whose cells share the first edges of the segment. Lanes outside the data have no
  /// missing posts.
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

/// The segments that raised the horizon of a block of receivers. The search on the next line begins
/// with them.
struct SegmentHints
{
  std::array<std::int32_t, 4> Segments{ { -1, -1, -1, -1 } };
  void Add(std::int32_t segment)
  {
    this->Segments = { { segment, this->Segments[0], this->Segments[1], this->Segments[2] } };
  }
};

/// All values of an azimuth that the search reads.
struct ExactState
{
  static constexpr std::ptrdiff_t NearLines = 16;   ///< lines that are searched without testing
                                                    ///< bounds
  static constexpr std::ptrdiff_t BoundMargin = 36; ///< lanes of bounds on each side of the data

  void Set(const RayFrame& frame, bool corners, double tolerance, float largestHeight);

  /// Lane, relative to that of the receiver, at which its ray enters the line `from` lines ahead.
  std::ptrdiff_t EntryLane(std::ptrdiff_t from) const
  {
    const std::ptrdiff_t whole = this->Frame->DriftAfter(from);
    return this->Frame->Drift > 0 ? whole : -whole - 1;
  }
  /// Metres by which curvature and refraction lower a post `from` lines ahead.
  float DropAt(std::ptrdiff_t from) const
  {
    return this->Frame->DropPerLine2 * static_cast<float>(from) * static_cast<float>(from);
  }

  /// Range of lanes of the bounds that the receivers need for a segment or group whose near edge is
  /// line `near`. Empty if all receivers lie beyond that line. `lines`: number of lines that the
  /// bounds cover.
  struct LaneRange
  {
    std::ptrdiff_t Begin, End;
  };
  LaneRange LanesAt(std::ptrdiff_t near, std::ptrdiff_t lines) const;

  const RayFrame* Frame = nullptr;
  std::ptrdiff_t LineBegin = 0, LineEnd = 0, LaneBegin = 0, LaneEnd = 0; ///< range of the receivers
  SegmentBounds Bounds;
  GapsInSegments Holes;
  std::array<SegmentReach, SegmentBounds::Lines + 1> Reach{};
  float Support = 0.0f, SupportInverse = 0.0f; ///< metres per line: slope of the tilted support,
                                               ///< and its inverse
  float TolerancePerLine = 0.0f;
  float Rounding = 0.0f; ///< metres: smaller differences between bound and horizon are rounding
                         ///< errors
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

/// The arguments of HorizonMethod::Find in the form that the vector code needs.
struct FindTask
{
  FindTask(const HeightField& field, const RayFrame& frame, std::ptrdiff_t lineBegin,
    std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin, std::ptrdiff_t laneEnd, float* slopes,
    std::ptrdiff_t stride)
    : LineBegin(lineBegin)
    , LineEnd(lineEnd)
    , LaneBegin(laneBegin)
    , LaneEnd(laneEnd)
    , Slopes(slopes)
    , Stride(stride)
    , Receivers(static_cast<std::size_t>(lineEnd - lineBegin))
    , Buffers(Receivers.size())
  {
    for (std::size_t i = 0; i < this->Receivers.size(); ++i)
    {
      const std::ptrdiff_t line = lineBegin + static_cast<std::ptrdiff_t>(i);
      this->Receivers[i] = field.Receivers(frame.Columns, frame.ImageLine(line), this->Buffers[i]);
    }
  }

  std::ptrdiff_t LineBegin, LineEnd, LaneBegin, LaneEnd;
  float* Slopes;
  std::ptrdiff_t Stride;
  std::vector<const float*> Receivers; ///< heights of the receivers, one pointer per line

private:
  std::vector<std::vector<float>> Buffers; // for lines whose receivers differ from the posts that
                                           // occlude
};

} // namespace skyline

#endif
