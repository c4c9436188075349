// SPDX-License-Identifier: BSD-3-Clause
// Horizons on the graphics processor: images of four azimuths each.
#ifndef skyline_GpuHorizons_h
#define skyline_GpuHorizons_h

#include "GpuDevice.h"

#include "Horizon/HorizonMethod.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace skyline
{

/// What may be asked of the graphics processor at a time.
struct GpuLimits
{
  int Side = 0;                                ///< greatest side of a texture; 0: OpenGL's own
  std::size_t Memory = std::size_t{ 1 } << 30; ///< bytes for the pyramid
};

/// A method of finding horizons; errors are std::runtime_error in one line. Azimuths come in fours.
class GpuHorizons
{
public:
  static constexpr int Group = 4;

  virtual ~GpuHorizons() = default;

  /// A surface, which outlives the calls that follow. heights: names its heights. What they do not
  /// change stays. Returns whether a pyramid was built.
  virtual bool Load(
    const HeightField& field, std::uint64_t heights, const HorizonSettings& settings) = 0;

  /// Greatest side of the tiles that Find fills.
  virtual int TileSide() const = 0;

  /// Horizons (radians) of the posts of a tile, within its rows [area.Y, area.Y + area.Height): to the
  /// same places of an image as large as the tile; tile.X, tile.Y: its first post. azimuths: radians, one to
  /// four; those that are not there get any horizon. grid: with the spacing that holds in the rows.
  virtual void Find(const GpuArea& tile, const GpuArea& area, const Grid& grid,
    const std::vector<double>& azimuths, vtkTextureObject* horizons) = 0;
};

/// The pyramid (Method Pyramid) or all edges (any other).
std::unique_ptr<GpuHorizons> MakeGpuHorizons(
  GpuDevice& device, HorizonMethodKind method, const GpuLimits& limits);

/// The text of a fragment shader: VTK's markers, then the parts.
std::string GpuText(const std::vector<std::string>& parts);

} // namespace skyline

#endif
