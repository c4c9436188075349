// SPDX-License-Identifier: BSD-3-Clause
#include "GpuPyramid.h"

#include "ShaderText.h"

#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace skyline
{

namespace
{

constexpr int TileWithCasters = 512; // posts; the levels of four azimuths then take some 200 MB

GpuTexture Checked(GpuTexture texture)
{
  if (!texture)
  {
    throw std::runtime_error("OpenGL has no memory for the pyramid");
  }
  return texture;
}

void Check(bool built)
{
  if (!built)
  {
    throw std::runtime_error("OpenGL cannot build the shaders of the pyramid");
  }
}

GpuTexture DecimationImage(
  GpuDevice& device, double ratio, std::ptrdiff_t fine, std::ptrdiff_t coarse)
{
  std::vector<float> values;
  for (const LinearTaps& taps : DecimationTaps(ratio, fine, coarse))
  {
    values.insert(values.end(),
      { static_cast<float>(taps.First), static_cast<float>(taps.Second), taps.Weight, 0.0f });
  }
  return Checked(device.Image(static_cast<int>(coarse), 1, 4, values.data()));
}

/// The range of samples of a level that the posts [begin, end) of an axis can read.
std::pair<std::ptrdiff_t, std::ptrdiff_t> SamplesFor(
  double begin, double end, double scale, std::ptrdiff_t samples)
{
  return { TapsAt(begin, scale, samples).Samples.front(),
    TapsAt(end, scale, samples).Samples.back() + 1 };
}

} // namespace

GpuPyramid::GpuPyramid(GpuDevice& device, const GpuLimits& limits)
  : Device(device)
  , Limits(limits)
{
}

bool GpuPyramid::Load(
  const HeightField& field, std::uint64_t heights, const HorizonSettings& settings)
{
  CheckPyramidSettings(settings.Pyramid);
  const Grid& grid = field.Posts();
  const PyramidSettings &before = this->Settings.Pyramid, &now = settings.Pyramid;
  if (grid.Columns != this->Columns || grid.Rows != this->Rows ||
    this->Components != (field.HasMissing() ? 2 : 1) || before.LevelStep != now.LevelStep ||
    before.LevelOffset != now.LevelOffset || before.Spline != now.Spline)
  {
    this->Heights = 0;
    this->Resize(field, settings);
  }
  this->Settings = settings;
  this->TileX = this->TileY = -1;
  if (heights == this->Heights)
  {
    return false;
  }
  this->Heights = 0; // set again when all levels are ready
  if (this->Whole)
  {
    this->BuildWhole(field);
  }
  else
  {
    this->Host = std::make_unique<HeightPyramid>(field, settings.Pyramid.LevelStep);
  }
  this->Heights = heights;
  return true;
}

void GpuPyramid::Resize(const HeightField& field, const HorizonSettings& settings)
{
  const Grid& grid = field.Posts();
  this->Columns = 0; // set again when all tables are ready
  this->Components = field.HasMissing() ? 2 : 1;
  this->Sizes = PyramidSizes(grid.Columns, grid.Rows, settings.Pyramid.LevelStep);
  const int levels = static_cast<int>(this->Sizes.size());
  this->First = PyramidReaches(this->Sizes, settings.Pyramid, grid, 0.0).front().Level;
  this->Levels.assign(this->Sizes.size(), Layer());
  for (auto* images : { &this->Across, &this->Along, &this->PostsAcross, &this->PostsAlong })
  {
    images->assign(this->Sizes.size(), nullptr);
  }
  this->Scratch = this->Receivers = this->Casters = nullptr;
  this->Host = nullptr;

  this->BuildPasses(settings);
  int side = std::min(this->Device.StackLimit(), this->Device.ImageLimit());
  side = this->Limits.Side > 0 ? std::min(side, this->Limits.Side) : side;
  const int layers = levels - this->First;
  const auto bytes = static_cast<std::size_t>(grid.Columns * grid.Rows) *
    static_cast<std::size_t>(layers * this->Components) * sizeof(float);
  const std::ptrdiff_t longest = std::max(grid.Columns, grid.Rows);
  this->Whole =
    longest <= side && layers <= this->Device.StackLimit() && bytes <= this->Limits.Memory;
  if (this->Whole)
  {
    this->Side = static_cast<int>(longest);
    this->MakeWholeImages(grid, layers);
  }
  else
  {
    this->MakeTileImages(side, layers);
  }
  this->Columns = grid.Columns;
  this->Rows = grid.Rows;
}

void GpuPyramid::BuildPasses(const HorizonSettings& settings)
{
  if (!this->Spline)
  {
    this->Decimate =
      std::make_unique<GpuPass>(this->Device, GpuText({ ShaderPart(skyline_GpuDecimate) }));
    this->Spline =
      std::make_unique<GpuPass>(this->Device, GpuText({ ShaderPart(skyline_GpuSpline) }));
  }
  this->Horizon = std::make_unique<GpuPass>(this->Device,
    GpuText({ ShaderPart(skyline_GpuAngles), ShaderPart(skyline_GpuPyramid),
      ShaderPart(skyline_GpuPyramid, this->Components == 2 ? "Missing" : "Whole"),
      ShaderPart(skyline_GpuPyramid, "Slopes"),
      ShaderPart(skyline_GpuPyramid, settings.Pyramid.Spline ? "Spline" : "Greatest"),
      ShaderPart(skyline_GpuPyramid, "Main") }));
}

void GpuPyramid::MakeTileImages(int side, int layers)
{
  this->Side = std::min(side - 1, TileWithCasters);
  if (this->Side < 1)
  {
    throw std::runtime_error("a texture holds fewer than two posts: raise the texture limit");
  }
  const int reach = this->Side + 1;
  this->Receivers = Checked(this->Device.Stack(reach, reach, layers, this->Components));
  this->Casters = Checked(this->Device.Stack(
    reach, reach, Group * static_cast<int>(this->Sizes.size()), this->Components));
}

void GpuPyramid::MakeWholeImages(const Grid& grid, int layers)
{
  const int levels = static_cast<int>(this->Sizes.size());
  const auto wide = static_cast<int>(grid.Columns);
  const auto high = static_cast<int>(grid.Rows);
  this->Receivers = Checked(this->Device.Stack(wide, high, layers, this->Components));
  this->Casters = this->Receivers;
  this->Scratch = Checked(this->Device.Image(wide, high, this->Components));
  for (int i = levels - 1; i >= 0; --i)
  {
    const auto index = static_cast<std::size_t>(i);
    const PyramidSize& size = this->Sizes[index];
    Layer& layer = this->Levels[index];
    layer.Columns = static_cast<int>(size.Columns);
    layer.Rows = static_cast<int>(size.Rows);
    if (i >= this->First)
    {
      this->PostsAcross[index] = this->Taps(i, 0, wide, false, 0, layer.Columns);
      this->PostsAlong[index] = this->Taps(i, 0, high, true, 0, layer.Rows);
    }
    if (i + 1 < levels && i >= this->First)
    {
      const PyramidSize& fine = this->Sizes[index + 1];
      const double ratio = size.Scale / fine.Scale;
      layer.Image = Checked(this->Device.Image(layer.Columns, layer.Rows, this->Components));
      this->Across[index] = DecimationImage(this->Device, ratio, fine.Columns, size.Columns);
      this->Along[index] = DecimationImage(this->Device, ratio, fine.Rows, size.Rows);
    }
  }
}

void GpuPyramid::BuildWhole(const HeightField& field)
{
  const auto posts = static_cast<std::size_t>(this->Columns * this->Rows);
  std::vector<float> values;
  values.reserve(posts * static_cast<std::size_t>(this->Components));
  for (std::ptrdiff_t row = 0; row < this->Rows; ++row)
  {
    const float* line = field.RowPlane().Line(row);
    for (std::ptrdiff_t column = 0; column < this->Columns; ++column)
    {
      const bool there = line[column] > 0.5f * MissingHeight;
      values.push_back(there ? line[column] : 0.0f);
      if (this->Components == 2)
      {
        values.push_back(there ? 1.0f : 0.0f);
      }
    }
  }
  this->Levels.back().Image = Checked(this->Device.Image(static_cast<int>(this->Columns),
    static_cast<int>(this->Rows), this->Components, values.data()));
  for (int i = static_cast<int>(this->Sizes.size()) - 2; i >= this->First; --i)
  {
    const auto index = static_cast<std::size_t>(i);
    const Layer& layer = this->Levels[index];
    Check(this->Decimate->Use());
    this->Decimate->Set("fine", this->Levels[index + 1].Image);
    this->Decimate->Set("across", this->Across[index]);
    this->Decimate->Set("along", this->Along[index]);
    this->Decimate->Draw({ layer.Image }, { 0, 0, layer.Columns, layer.Rows });
  }
  const GpuArea all{ 0, 0, static_cast<int>(this->Columns), static_cast<int>(this->Rows) };
  for (int i = this->First; i < static_cast<int>(this->Sizes.size()); ++i)
  {
    const auto index = static_cast<std::size_t>(i);
    this->Expand(this->Levels[index], i, all, this->Receivers, i - this->First,
      this->PostsAcross[index], this->PostsAlong[index]);
  }
}

// Weights and samples of the posts begin to begin + posts - 1. Sample numbers are relative to the
// first loaded one.
GpuTexture GpuPyramid::Taps(
  int level, std::ptrdiff_t begin, int posts, bool rows, std::ptrdiff_t first, int samples)
{
  const PyramidSize& size = this->Sizes[static_cast<std::size_t>(level)];
  const std::ptrdiff_t count = rows ? size.Rows : size.Columns;
  const bool finest = level + 1 == static_cast<int>(this->Sizes.size()); // not interpolated
  const auto width = static_cast<std::size_t>(posts);
  std::vector<float> values(8 * width);
  for (std::size_t post = 0; post < width; ++post)
  {
    const std::ptrdiff_t place = begin + static_cast<std::ptrdiff_t>(post);
    SplineTaps taps;
    if (finest)
    {
      taps.Weights[0] = 1.0f;
      taps.Samples.fill(std::clamp<std::ptrdiff_t>(place, 0, count - 1));
    }
    else
    {
      taps = TapsAt(static_cast<double>(place), size.Scale, count);
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      values[4 * post + k] = taps.Weights[k];
      values[4 * (width + post) + k] =
        static_cast<float>(std::clamp<std::ptrdiff_t>(taps.Samples[k] - first, 0, samples - 1));
    }
  }
  return Checked(this->Device.Image(posts, 2, 4, values.data()));
}

/// Interpolates a level at the posts of a rectangle, which may extend beyond the data, into a layer
/// of a stack.
void GpuPyramid::Expand(const Layer& layer, int level, const GpuArea& posts,
  vtkTextureObject* stack, int index, vtkTextureObject* across, vtkTextureObject* along)
{
  GpuTexture madeAcross, madeAlong;
  if (!across)
  {
    madeAcross = this->Taps(level, posts.X, posts.Width, false, layer.FirstColumn, layer.Columns);
    madeAlong = this->Taps(level, posts.Y, posts.Height, true, layer.FirstRow, layer.Rows);
    across = madeAcross;
    along = madeAlong;
  }
  Check(this->Spline->Use());
  this->Spline->Set("samples", layer.Image);
  this->Spline->Set("taps", across);
  this->Spline->Set("vertical", 0);
  this->Spline->Draw({ this->Scratch }, { 0, 0, posts.Width, layer.Rows });
  Check(this->Spline->Use());
  this->Spline->Set("samples", this->Scratch);
  this->Spline->Set("taps", along);
  this->Spline->Set("vertical", 1);
  this->Spline->DrawLayer(stack, index, { 0, 0, posts.Width, posts.Height });
}

/// Loads the samples of each level that the receivers of a tile and their casters in all azimuths
/// read.
void GpuPyramid::LoadTile(const GpuArea& tile)
{
  if (tile.X == this->TileX && tile.Y == this->TileY)
  {
    return;
  }
  int highest = 1;
  const auto levels = static_cast<int>(this->Sizes.size());
  const std::vector<PyramidReach> reaches = PyramidReaches(
    this->Sizes, this->Settings.Pyramid, Grid{ this->Columns, this->Rows, 1.0, 1.0 }, 0.0);
  for (int i = this->First; i < levels; ++i)
  {
    double distance = 0.0; // posts
    for (const PyramidReach& reach : reaches)
    {
      distance = reach.Level == i ? std::max(distance, std::ceil(reach.Distance) + 2.0) : distance;
    }
    const PyramidLevel& level = this->Host->Level(i);
    const auto columns =
      SamplesFor(tile.X - distance, tile.X + tile.Width + distance, level.Scale, level.Columns);
    const auto rows =
      SamplesFor(tile.Y - distance, tile.Y + tile.Height + distance, level.Scale, level.Rows);
    Layer& layer = this->Levels[static_cast<std::size_t>(i)];
    layer.FirstColumn = columns.first;
    layer.FirstRow = rows.first;
    layer.Columns = static_cast<int>(columns.second - columns.first);
    layer.Rows = static_cast<int>(rows.second - rows.first);
    highest = std::max(highest, layer.Rows);
    std::vector<float> values;
    for (std::ptrdiff_t row = rows.first; row < rows.second; ++row)
    {
      for (std::ptrdiff_t column = columns.first; column < columns.second; ++column)
      {
        const auto sample = static_cast<std::size_t>(row * level.Columns + column);
        values.push_back(level.Heights[sample]);
        if (this->Components == 2)
        {
          values.push_back(level.Coverage[sample]);
        }
      }
    }
    layer.Image =
      Checked(this->Device.Image(layer.Columns, layer.Rows, this->Components, values.data()));
  }
  const auto wide = static_cast<unsigned int>(this->Side + 1);
  if (!this->Scratch || this->Scratch->GetHeight() < static_cast<unsigned int>(highest))
  {
    this->Scratch = Checked(this->Device.Image(static_cast<int>(wide), highest, this->Components));
  }
  for (int i = this->First; i < levels; ++i)
  {
    this->Expand(
      this->Levels[static_cast<std::size_t>(i)], i, tile, this->Receivers, i - this->First);
  }
  this->TileX = tile.X;
  this->TileY = tile.Y;
}

// Fills layer Group * level + azimuth of the stack: the level at the casters of the tile.
void GpuPyramid::FillCasters(
  const GpuArea& tile, const std::vector<std::vector<PyramidReach>>& reaches)
{
  for (std::size_t azimuth = 0; azimuth < reaches.size(); ++azimuth)
  {
    int layer = static_cast<int>(azimuth);
    for (const PyramidReach& reach : reaches[azimuth])
    {
      const GpuArea posts{ tile.X + static_cast<int>(std::floor(reach.East + 1.0e-9)),
        tile.Y + static_cast<int>(std::floor(reach.North + 1.0e-9)), tile.Width + 1,
        tile.Height + 1 };
      // No receiver reads samples that lie beyond the data.
      if (posts.X < this->Columns && posts.Y < this->Rows && posts.X + posts.Width > 0 &&
        posts.Y + posts.Height > 0)
      {
        this->Expand(this->Levels[static_cast<std::size_t>(reach.Level)], reach.Level, posts,
          this->Casters, layer);
      }
      layer += Group;
    }
  }
}

// The table of reaches that GpuPyramid.glsl reads.
GpuTexture GpuPyramid::Reaches(
  const GpuArea&, const std::vector<std::vector<PyramidReach>>& reaches)
{
  constexpr double snap = 1.0e-9; // posts, as in HorizonPyramid.cxx
  const std::size_t levels = this->Sizes.size();
  std::vector<float> values(12 * levels * Group, 0.0f); // no receiver has its caster in the data
  for (std::size_t azimuth = 0; azimuth < reaches.size(); ++azimuth)
  {
    float* texel = values.data() + 12 * levels * azimuth;
    int layer = static_cast<int>(azimuth);
    for (const PyramidReach& reach : reaches[azimuth])
    {
      const double west = std::floor(reach.East + snap);
      const double south = std::floor(reach.North + snap);
      const auto lastColumn = static_cast<double>(this->Columns - 1);
      const auto lastRow = static_cast<double>(this->Rows - 1);
      const double numbers[12] = { this->Whole ? west : 0.0, this->Whole ? south : 0.0,
        std::max(0.0, reach.East - west), std::max(0.0, reach.North - south),
        1.0 * (this->Whole ? reach.Level - this->First : layer), 1.0 * (reach.Level - this->First),
        1.0 / reach.Distance, this->Settings.CurvatureDrop * reach.Distance,
        std::max(0.0, std::ceil(-reach.East - snap)),
        std::min(lastColumn, std::floor(lastColumn - reach.East + snap)) + 1.0,
        std::max(0.0, std::ceil(-reach.North - snap)),
        std::min(lastRow, std::floor(lastRow - reach.North + snap)) + 1.0 };
      for (const double number : numbers)
      {
        *texel++ = static_cast<float>(number);
      }
      layer += Group;
    }
  }
  for (std::size_t i = 0; i < levels * Group; ++i)
  {
    // Parts of a post below the precision of a float count as 0; otherwise a post beyond the data
    // would be read.
    values[12 * i + 2] = values[12 * i + 2] > 1.0e-9f ? values[12 * i + 2] : 0.0f;
    values[12 * i + 3] = values[12 * i + 3] > 1.0e-9f ? values[12 * i + 3] : 0.0f;
  }
  return Checked(this->Device.Image(3 * static_cast<int>(levels), Group, 4, values.data()));
}

void GpuPyramid::Find(const GpuArea& tile, const GpuArea& area, const Grid& grid,
  const std::vector<double>& azimuths, vtkTextureObject* horizons)
{
  std::vector<std::vector<PyramidReach>> reaches;
  reaches.reserve(azimuths.size());
  for (const double azimuth : azimuths)
  {
    reaches.push_back(PyramidReaches(this->Sizes, this->Settings.Pyramid, grid, azimuth));
  }
  if (!this->Whole)
  {
    this->LoadTile(tile);
    this->FillCasters(tile, reaches);
  }
  const GpuTexture table = this->Reaches(tile, reaches);
  Check(this->Horizon->Use());
  this->Horizon->Set("casters", this->Casters);
  this->Horizon->Set("receivers", this->Receivers);
  this->Horizon->Set("reaches", table);
  this->Horizon->Set("levels", static_cast<int>(this->Sizes.size()));
  this->Horizon->Set("tile", this->Whole ? 0 : tile.X, this->Whole ? 0 : tile.Y);
  this->Horizon->Draw({ horizons }, area);
}

} // namespace skyline
