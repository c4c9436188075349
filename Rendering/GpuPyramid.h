// SPDX-License-Identifier: BSD-3-Clause
// The height pyramid of Snyder & Nowrouzezahrai (2008) on the graphics processor: the counterpart
// of HorizonPyramid.
#ifndef skyline_GpuPyramid_h
#define skyline_GpuPyramid_h

#include "GpuHorizons.h"

#include "Horizon/HorizonPyramid.h"

#include <memory>
#include <vector>

namespace skyline
{

/// If the memory allows it, the pyramid is built on the graphics processor from the heights alone,
/// and all levels that are read lie there at full size, as in the paper. Otherwise HeightPyramid
/// builds the levels, and each tile loads the part that its receivers and casters need.
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
  struct Layer // the loaded part of one level
  {
    GpuTexture Image;
    std::ptrdiff_t FirstColumn = 0, FirstRow = 0; // of the loaded samples, in the level
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
  std::uint64_t Heights = 0; // identifies the heights of the loaded pyramid; 0: none
  std::ptrdiff_t Columns = 0, Rows = 0;
  int Components = 0; // 2 with missing posts: height times coverage, and coverage
  bool Whole = false;
  int Side = 0;
  int First = 0; // the coarsest level that is read
  std::vector<PyramidSize> Sizes;
  std::vector<Layer> Levels;
  std::vector<GpuTexture> Across, Along;           // for each level: samples from finer ones
  std::vector<GpuTexture> PostsAcross, PostsAlong; // for each level: posts from samples
  GpuTexture Scratch, Receivers, Casters;
  std::unique_ptr<HeightPyramid> Host; // used with tiles
  int TileX = -1, TileY = -1;          // the tile whose receivers are loaded
  std::unique_ptr<GpuPass> Decimate, Spline, Horizon;
};

} // namespace skyline

#endif
