// SPDX-License-Identifier: BSD-3-Clause
// Exact horizons on the graphics processor: the counterpart of HorizonExact, without its bounds.
#ifndef skyline_GpuExact_h
#define skyline_GpuExact_h

#include "GpuHorizons.h"

#include <memory>
#include <vector>

namespace skyline
{

/// Every receiver walks its whole ray. A field larger than a texture lies in several, which share their
/// outermost posts, so that each edge lies in one of them; the greatest of their horizons counts.
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
  double Sink = 0.0;
  int Side = 0;
  std::vector<Sheet> Sheets;
  GpuTexture Receivers;
  GpuArea Tile; // whose receivers are there
  std::unique_ptr<GpuPass> Pass;
};

} // namespace skyline

#endif
