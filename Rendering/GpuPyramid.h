// SPDX-License-Identifier: BSD-3-Clause
// The pyramid of Snyder & Nowrouzezahrai 2008 on the graphics processor: the counterpart of HorizonPyramid.
#ifndef skyline_GpuPyramid_h
#define skyline_GpuPyramid_h

#include "GpuHorizons.h"

#include "Horizon/HorizonPyramid.h"

#include <memory>
#include <vector>

namespace skyline
{

/// Where it fits, the pyramid is built there from nothing but the heights, and all levels that are read
/// lie there at full size, as SN08 have them. Else the levels are built by HeightPyramid and each tile
/// takes from them what its receivers and casters need.
class GpuPyramid : public GpuHorizons
{
public:
  GpuPyramid(GpuDevice& device, const GpuLimits& limits);

  bool Load(
    const HeightField& field, std::uint64_t heights, const HorizonSettings& settings) override;
  int TileSide() const override { return this->Side; }
  void Find(const GpuArea& tile, const GpuArea& area, const Grid& grid,
    const std::vector<double>& azimuths, vtkTextureObject* horizons) override;

private:
  struct Layer // one level where it is needed
  {
    GpuTexture Image;
    std::ptrdiff_t FirstColumn = 0, FirstRow = 0; // of the level's samples, in the image
    int Columns = 0, Rows = 0;
  };

  void Resize(const HeightField& field, const HorizonSettings& settings);
  void BuildPasses(const HorizonSettings& settings);
  void MakeTileImages(int side, int layers);
  void MakeWholeImages(const Grid& grid, int layers);
  void BuildWhole(const HeightField& field);
  void LoadTile(const GpuArea& tile);
  void FillCasters(const GpuArea& tile, const std::vector<std::vector<PyramidReach>>& reaches);
  void Expand(const Layer& layer, int level, const GpuArea& posts, vtkTextureObject* stack,
    int index, vtkTextureObject* across = nullptr, vtkTextureObject* along = nullptr);
  GpuTexture Taps(
    int level, std::ptrdiff_t begin, int posts, bool rows, std::ptrdiff_t first, int samples);
  GpuTexture Reaches(const GpuArea& tile, const std::vector<std::vector<PyramidReach>>& reaches);

  GpuDevice& Device;
  GpuLimits Limits;
  HorizonSettings Settings;
  std::uint64_t Heights = 0; // of the pyramid that is there; 0: none
  std::ptrdiff_t Columns = 0, Rows = 0;
  int Components = 0; // 2 with missing posts: heights times coverage, and coverage
  bool Whole = false;
  int Side = 0;
  int First = 0; // the coarsest level that is read
  std::vector<PyramidSize> Sizes;
  std::vector<Layer> Levels;
  std::vector<GpuTexture> Across, Along;           // of each level: samples from finer ones
  std::vector<GpuTexture> PostsAcross, PostsAlong; // of each level: posts from samples
  GpuTexture Scratch, Receivers, Casters;
  std::unique_ptr<HeightPyramid> Host; // with tiles
  int TileX = -1, TileY = -1;          // whose receivers are there
  std::unique_ptr<GpuPass> Decimate, Spline, Horizon;
};

} // namespace skyline

#endif
