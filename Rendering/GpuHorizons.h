// SPDX-License-Identifier: BSD-3-Clause
// Horizons on the graphics processor, in images of four azimuths each.
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

/// Limits of what the graphics processor does at once.
struct GpuLimits
{
  int Side = 0;                                ///< greatest side of a texture; 0: OpenGL's limit
  std::size_t Memory = std::size_t{ 1 } << 30; ///< bytes for the pyramid
};

/// A method that finds horizons, for up to four azimuths at once. Errors are std::runtime_error
/// with a reason of one line.
class GpuHorizons
{
public:
  static constexpr int Group = 4;

  virtual ~GpuHorizons() = default;

  /// Loads a surface, which must stay alive during the calls that follow. heights: a number that
  /// identifies the heights; what depends on them alone is kept while it stays the same. Returns
  /// whether a pyramid was built.
  virtual bool Load(
    const HeightField& field, std::uint64_t heights, const HorizonSettings& settings) = 0;

  /// Greatest side of the tiles that Find can fill, in posts.
  virtual int TileSide() const = 0;

  /// Finds the horizons (radians) of the posts of a tile, in its rows area.Y to area.Y +
  /// area.Height - 1, and writes them to the same places of an image that is as large as the tile.
  /// tile.X, tile.Y: the first post of the tile. azimuths: one to four, in radians; the values of
  /// the unused channels are arbitrary. grid: the grid with the spacing of these rows.
  virtual void Find(const GpuArea& tile, const GpuArea& area, const Grid& grid,
    const std::vector<double>& azimuths, vtkTextureObject* horizons) = 0;
};

/// Makes GpuPyramid for the method Pyramid and GpuExact for every other method.
std::unique_ptr<GpuHorizons> MakeGpuHorizons(
  GpuDevice& device, HorizonMethodKind method, const GpuLimits& limits);

/// The text of a fragment shader: VTK's markers, followed by the parts.
std::string GpuText(const std::vector<std::string>& parts);

} // namespace skyline

#endif
