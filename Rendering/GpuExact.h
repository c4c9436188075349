// SPDX-License-Identifier: BSD-3-Clause
// Exact horizons on the graphics processor. Unlike HorizonExact it uses no bounds to stop early.
#ifndef skyline_GpuExact_h
#define skyline_GpuExact_h

#include "GpuHorizons.h"

#include <memory>
#include <vector>

namespace skyline
{

/// Each receiver follows its ray to the edge of the data. A field larger than a texture is divided
/// into several sheets, which share their outermost posts so that each edge lies in one sheet. The
/// horizon is the greatest over all sheets.
class GpuExact : public GpuHorizons
{
public:
  GpuExact(GpuDevice& device, const GpuLimits& limits);

  bool Load(
    const HeightField& field, std::uint64_t heights, const HorizonSettings& settings) override;
  int TileSide() const override { return this->Side; }
  void Find(const GpuArea& tile, const GpuArea& area, const Grid& grid,
    const std::vector<double>& azimuths, vtkTextureObject* horizons) override;

private:
  struct Sheet
  {
    GpuArea Posts;
    GpuTexture Heights;
  };
  void LoadTile(const GpuArea& tile);
  void Walk(const GpuArea& tile, const GpuArea& area, const RayFrame& frame, const Sheet& sheet,
    vtkTextureObject* steps, int channel, bool first, vtkTextureObject* horizons);

  GpuDevice& Device;
  GpuLimits Limits;
  const HeightField* Field = nullptr;
  double CurvatureDrop = 0.0;
  int Side = 0;
  std::vector<Sheet> Sheets;
  GpuTexture Receivers;
  GpuArea Tile; // the tile whose receivers are loaded
  std::unique_ptr<GpuPass> Pass;
};

} // namespace skyline

#endif
