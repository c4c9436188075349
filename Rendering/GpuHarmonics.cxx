// SPDX-License-Identifier: BSD-3-Clause
#include "GpuHarmonics.h"

#include "GpuWedgeText.h"
#include "GpuWedgeWeights.h"
#include "Harmonics/SphericalHarmonics.h"
#include "HorizonDriver.h"

#include "vtkTextureObject.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace skyline
{

namespace
{

constexpr int PerImage = CoefficientsPerImage;
constexpr int PerPass = PerImage * ImagesPerPass;

double Now()
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

void Check(bool built)
{
  if (!built)
  {
    throw std::runtime_error("OpenGL cannot build the shaders of harmonics");
  }
}

GpuTexture Checked(GpuTexture texture)
{
  if (!texture)
  {
    throw std::runtime_error("OpenGL has no memory for harmonics");
  }
  return texture;
}

} // namespace

/// Adds its lifetime to a sum of seconds.
class GpuHarmonics::StageTimer
{
public:
  StageTimer(GpuHarmonics& owner, double& sum)
    : Owner(owner)
    , Sum(sum)
    , Start(owner.Times.Wanted ? Now() : 0.0)
  {
  }
  ~StageTimer()
  {
    if (this->Owner.Times.Wanted)
    {
      this->Owner.Device.Finish();
      this->Sum += Now() - this->Start;
    }
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

private:
  GpuHarmonics& Owner;
  double& Sum;
  double Start;
};

GpuHarmonics::GpuHarmonics(GpuDevice& device, const GpuLimits& limits)
  : Device(device)
  , Limits(limits)
{
}

GpuHarmonics::~GpuHarmonics() = default;

std::string GpuHarmonics::UnsupportedSetting(const HorizonSettings& settings)
{
  if (settings.Method == HorizonMethodKind::Sweep)
  {
    return "the sweep has no counterpart on the graphics processor";
  }
  if (settings.Method != HorizonMethodKind::Pyramid && settings.Shape == Surface::Bilinear)
  {
    return "bilinear surfaces have no counterpart on the graphics processor";
  }
  return {};
}

bool GpuHarmonics::FitsOneTile(HorizonDriver& driver)
{
  const HorizonSettings& settings = driver.UsedSettings();
  const Grid& grid = driver.Input().Posts();
  const GpuState state(this->Device);
  if (!this->Horizons || this->Method != settings.Method)
  {
    this->Horizons = MakeGpuHorizons(this->Device, settings.Method, this->Limits);
    this->Method = settings.Method;
  }
  {
    const StageTimer timer(*this, this->Times.Load);
    if (settings.Method != HorizonMethodKind::Pyramid)
    {
      driver.Input().Transpose();
    }
    const bool pyramid = settings.Method == HorizonMethodKind::Pyramid;
    const std::uint64_t heights = pyramid ? driver.Input().Checksum() : 0;
    driver.PyramidBuilds += this->Horizons->Load(driver.Input().Field(), heights, settings) ? 1 : 0;
  }
  this->Side = std::min(this->Horizons->TileSide(), this->Device.ImageLimit());
  this->Side = this->Limits.Side > 0 ? std::min(this->Side, this->Limits.Side) : this->Side;
  if (this->Side < 1)
  {
    throw std::runtime_error("OpenGL allows no textures");
  }
  return std::max(grid.Columns, grid.Rows) <= this->Side;
}

std::vector<GpuArea> GpuHarmonics::Tiles(const Grid& grid) const
{
  const int columns = static_cast<int>(grid.Columns);
  const int rows = static_cast<int>(grid.Rows);
  std::vector<GpuArea> tiles;
  for (int row = 0; row < rows; row += this->Side)
  {
    for (int column = 0; column < columns; column += this->Side)
    {
      tiles.push_back(
        { column, row, std::min(this->Side, columns - column), std::min(this->Side, rows - row) });
    }
  }
  return tiles;
}

bool GpuHarmonics::Run(HorizonDriver& driver, const Task& task)
{
  const GpuState state(this->Device);
  double done = 0.0;
  const std::vector<GpuArea> tiles = this->Tiles(driver.Input().Posts());
  for (const GpuArea& tile : tiles)
  {
    const double before = done;
    done += 1.0 / static_cast<double>(tiles.size());
    if (!this->SumTile(driver, task, tile, before, done))
    {
      return false;
    }
    if (task.Values)
    {
      const StageTimer timer(*this, this->Times.Read);
      this->ReadTile(driver, task, tile);
    }
  }
  return true;
}

bool GpuHarmonics::Store(HorizonDriver& driver, const std::vector<double>& azimuths, float* degrees)
{
  const GpuState state(this->Device);
  const std::vector<GpuArea> tiles = this->Tiles(driver.Input().Posts());
  const std::ptrdiff_t columns = driver.Input().Posts().Columns;
  const std::size_t count = azimuths.size();
  double done = 0.0;
  std::vector<float> texels;
  for (const GpuArea& tile : tiles)
  {
    const GpuTexture angles = Checked(this->Device.Image(tile.Width, tile.Height, 4));
    texels.resize(static_cast<std::size_t>(4 * tile.Width) * static_cast<std::size_t>(tile.Height));
    for (std::size_t first = 0; first < count; first += GpuHorizons::Group)
    {
      const std::size_t here = std::min<std::size_t>(GpuHorizons::Group, count - first);
      if (driver.Progress && !driver.Progress(done / static_cast<double>(tiles.size() * count)))
      {
        return false;
      }
      done += static_cast<double>(here);
      const auto begin = azimuths.begin() + static_cast<std::ptrdiff_t>(first);
      this->FindRows(driver, tile, { begin, begin + static_cast<std::ptrdiff_t>(here) }, angles);
      const StageTimer timer(*this, this->Times.Read);
      this->Device.Read(angles, { 0, 0, tile.Width, tile.Height }, texels.data());
      const float* texel = texels.data();
      for (std::ptrdiff_t row = tile.Y; row < tile.Y + tile.Height; ++row)
      {
        for (std::ptrdiff_t column = tile.X; column < tile.X + tile.Width; ++column, texel += 4)
        {
          float* to = degrees + static_cast<std::size_t>(row * columns + column) * count + first;
          std::transform(texel, texel + here, to,
            [](float angle)
            {
              // Where there is no terrain, the horizon is exactly -90 degrees.
              return angle <= static_cast<float>(-0.5 * Pi)
                ? -90.0f
                : angle * static_cast<float>(DegreesPerRadian);
            });
        }
      }
    }
  }
  return true;
}

void GpuHarmonics::FindRows(HorizonDriver& driver, const GpuArea& tile,
  const std::vector<double>& azimuths, vtkTextureObject* angles)
{
  const StageTimer timer(*this, this->Times.Horizons);
  for (const RowBand& band : driver.Input().Bands())
  {
    const int from = std::max(static_cast<int>(band.RowBegin), tile.Y);
    const int to = std::min(static_cast<int>(band.RowEnd), tile.Y + tile.Height);
    if (from < to)
    {
      const Grid grid = WithSpacing(driver.Input().Posts(), band);
      this->Horizons->Find(
        tile, { 0, from - tile.Y, tile.Width, to - from }, grid, azimuths, angles);
    }
  }
}

void GpuHarmonics::Prepare(const Task& task, const GpuArea& tile)
{
  const bool transfer = task.East != nullptr;
  const int count = HarmonicCount(task.Bands);
  const bool changed = task.Bands != this->Bands || transfer != this->Transfer;
  if (changed)
  {
    this->Bands = 0; // set again when all passes are ready
    this->Wedges.clear();
    for (int begin = 0; begin < count; begin += PerPass)
    {
      this->Wedges.push_back(std::make_unique<GpuPass>(
        this->Device, WedgeText(task.Bands, transfer, begin, std::min(begin + PerPass, count))));
    }
  }
  if (changed || tile.Width != this->Width || tile.Height != this->Height)
  {
    this->Sums.clear();
    for (int i = 0; i < count; i += PerImage)
    {
      this->Sums.push_back(Checked(this->Device.Image(tile.Width, tile.Height, PerImage)));
    }
    this->Angles = Checked(this->Device.Image(tile.Width, tile.Height, 4));
    this->Lit = nullptr;
  }
  if (transfer)
  {
    std::vector<float> gradients;
    gradients.reserve(
      static_cast<std::size_t>(2 * tile.Width) * static_cast<std::size_t>(tile.Height));
    const std::ptrdiff_t columns = this->Columns;
    for (std::ptrdiff_t row = tile.Y; row < tile.Y + tile.Height; ++row)
    {
      for (std::ptrdiff_t post = row * columns + tile.X; post < row * columns + tile.X + tile.Width;
           ++post)
      {
        gradients.push_back(task.East[post]);
        gradients.push_back(task.North[post]);
      }
    }
    this->Gradients = Checked(this->Device.Image(tile.Width, tile.Height, 2, gradients.data()));
  }
  this->Bands = task.Bands;
  this->Transfer = transfer;
  this->Width = tile.Width;
  this->Height = tile.Height;
}

bool GpuHarmonics::SumTile(
  HorizonDriver& driver, const Task& task, const GpuArea& tile, double begin, double end)
{
  this->Columns = driver.Input().Posts().Columns;
  {
    const StageTimer timer(*this, this->Times.Load);
    this->Prepare(task, tile);
  }
  const std::vector<double>& azimuths = *task.Azimuths;
  const auto wholes = WholeSums(task.Bands, azimuths, task.Width, this->Transfer);
  const std::size_t count = azimuths.size();
  for (std::size_t first = 0; first < count; first += GpuHorizons::Group)
  {
    const std::size_t last = std::min(first + GpuHorizons::Group, count);
    if (driver.Progress &&
      !driver.Progress(
        begin + (end - begin) * static_cast<double>(first) / static_cast<double>(count)))
    {
      return false;
    }
    const std::vector<double> group(azimuths.begin() + static_cast<std::ptrdiff_t>(first),
      azimuths.begin() + static_cast<std::ptrdiff_t>(last));
    this->FindRows(driver, tile, group, this->Angles);
    const StageTimer timer(*this, this->Times.Wedges);
    const std::vector<float> texels = WedgeTexels(task.Bands, group, task.Width);
    const GpuTexture weights =
      Checked(this->Device.Image(static_cast<int>(texels.size() / 4), 1, 4, texels.data()));
    for (std::size_t pass = 0; pass < this->Wedges.size(); ++pass)
    {
      GpuPass& wedge = *this->Wedges[pass];
      Check(wedge.Use());
      wedge.Set("horizons", this->Angles);
      wedge.Set("weights", weights);
      wedge.Set("whole", first == 0 ? 1.0f : 0.0f);
      std::vector<float> vectors(static_cast<std::size_t>(3 * PerPass), 0.0f);
      for (std::size_t part = 0; part < 3; ++part)
      {
        for (std::size_t c = 0; c < PerPass && pass * PerPass + c < wholes[part].size(); ++c)
        {
          vectors[part * PerPass + c] = static_cast<float>(wholes[part][pass * PerPass + c]);
        }
      }
      wedge.Set("wholes", vectors);
      if (this->Transfer)
      {
        wedge.Set("gradients", this->Gradients);
      }
      std::vector<vtkTextureObject*> targets;
      for (std::size_t i = pass * ImagesPerPass;
           i < std::min((pass + 1) * ImagesPerPass, this->Sums.size()); ++i)
      {
        targets.push_back(this->Sums[i]);
      }
      wedge.Draw(
        targets, { 0, 0, tile.Width, tile.Height }, first != 0 ? GpuBlend::Add : GpuBlend::Replace);
    }
  }
  return true;
}

void GpuHarmonics::ReadTile(HorizonDriver& driver, const Task& task, const GpuArea& tile)
{
  const std::ptrdiff_t columns = driver.Input().Posts().Columns;
  const int count = HarmonicCount(task.Bands);
  std::vector<float> texels(
    static_cast<std::size_t>(4 * tile.Width) * static_cast<std::size_t>(tile.Height));
  for (std::size_t i = 0; i < this->Sums.size(); ++i)
  {
    this->Device.Read(this->Sums[i], { 0, 0, tile.Width, tile.Height }, texels.data());
    const auto first = PerImage * static_cast<int>(i);
    const int here = std::min(PerImage, count - first);
    const float* texel = texels.data();
    for (std::ptrdiff_t row = tile.Y; row < tile.Y + tile.Height; ++row)
    {
      float* to = task.Values + (row * columns + tile.X) * count + first;
      for (int column = 0; column < tile.Width; ++column, texel += 4, to += count)
      {
        std::copy_n(texel, here, to);
      }
    }
  }
}

void GpuHarmonics::ReadImage(vtkTextureObject* image, float* texels)
{
  const StageTimer timer(*this, this->Times.Read);
  this->Device.Read(image, { 0, 0, this->Width, this->Height }, texels);
}

GpuTexture GpuHarmonics::Light(const std::vector<double>& coefficients)
{
  const GpuState state(this->Device);
  const StageTimer timer(*this, this->Times.Light);
  if (!this->Lighting || this->LitImages != this->Sums.size())
  {
    this->Lighting =
      std::make_unique<GpuPass>(this->Device, LightText(static_cast<int>(this->Sums.size())));
    this->LitImages = this->Sums.size();
  }
  if (!this->Lit)
  {
    this->Lit = Checked(this->Device.Image(this->Width, this->Height, 4));
    this->Lit->SetMinificationFilter(vtkTextureObject::Linear);
    this->Lit->SetMagnificationFilter(vtkTextureObject::Linear);
  }
  const std::size_t count = coefficients.size() / 3;
  std::vector<float> light(12 * this->Sums.size(), 0.0f);
  for (std::size_t c = 0; c < coefficients.size(); ++c)
  {
    const std::size_t i = c % count;
    light[12 * (i / PerImage) + 4 * (c / count) + i % PerImage] =
      static_cast<float>(coefficients[c]);
  }
  Check(this->Lighting->Use());
  for (std::size_t i = 0; i < this->Sums.size(); ++i)
  {
    this->Lighting->Set(("image" + std::to_string(i)).c_str(), this->Sums[i].GetPointer());
  }
  this->Lighting->Set("light", light);
  this->Lighting->Draw({ this->Lit }, { 0, 0, this->Width, this->Height });
  return this->Lit;
}

} // namespace skyline
