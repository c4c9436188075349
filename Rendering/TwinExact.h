// SPDX-License-Identifier: BSD-3-Clause
// Exact horizons on the graphics processor: twin of HorizonExact, without its bounds.
#ifndef skyline_TwinExact_h
#define skyline_TwinExact_h

#include "TwinHorizons.h"

#include <memory>
#include <vector>

namespace skyline
{

/// Every receiver walks its whole ray. A field larger than a texture lies in several, which share their
/// outermost posts, so that each edge lies in one of them; the greatest of their horizons counts.
class TwinExact : public TwinHorizons
{
public:
  TwinExact(TwinDevice& device, const TwinLimits& limits);

  bool Load(
    const HeightField& field, std::uint64_t heights, const HorizonSettings& settings) override;
  int TileSide() const override { return this->Side; }
  void Find(const TwinArea& tile, const TwinArea& area, const Grid& grid,
    const std::vector<double>& azimuths, vtkTextureObject* horizons) override;

private:
  struct Sheet
  {
    TwinArea Posts;
    TwinTexture Heights;
  };
  void LoadTile(const TwinArea& tile);
  void Walk(const TwinArea& tile, const TwinArea& area, const RayFrame& frame, const Sheet& sheet,
    vtkTextureObject* steps, int channel, bool first, vtkTextureObject* horizons);

  TwinDevice& Device;
  TwinLimits Limits;
  const HeightField* Field = nullptr;
  double Sink = 0.0;
  int Side = 0;
  std::vector<Sheet> Sheets;
  TwinTexture Receivers;
  TwinArea Tile; // whose receivers are there
  std::unique_ptr<TwinPass> Pass;
};

} // namespace skyline

#endif
