// SPDX-License-Identifier: BSD-3-Clause
#include "GpuExact.h"

#include "Horizon/RayFrame.h"
#include "ShaderText.h"

#include "vtkTextureObject.h"

#include <algorithm>
#include <stdexcept>

namespace skyline
{

namespace
{

constexpr int RowLength = 1024; // steps per row of the table, as in GpuExact.glsl

GpuTexture Checked(GpuTexture texture)
{
  if (!texture)
  {
    throw std::runtime_error("OpenGL has no memory for the heights");
  }
  return texture;
}

GpuTexture StepTable(GpuDevice& device, const RayFrame& frame)
{
  const std::size_t rows = (frame.Steps.size() + RowLength - 1) / RowLength;
  std::vector<float> values(16 * RowLength * rows, 0.0f);
  float* texel = values.data();
  for (std::size_t d = 0; d < frame.Steps.size(); ++d)
  {
    const RayStep& step = frame.Steps[d];
    const SideStep& side = frame.Sides[d];
    const float numbers[16] = { static_cast<float>(step.Lane), static_cast<float>(step.Next),
      step.RowTrail, step.RowLead, step.RowDrop, step.MidNear, step.MidFar, step.MidDrop,
      side.LeftNear, side.LeftFar, side.LeftDrop, 0.0f, side.RightNear, side.RightFar,
      side.RightDrop, 0.0f };
    texel = std::copy(numbers, numbers + 16, texel);
  }
  return Checked(device.Image(4 * RowLength, static_cast<int>(rows), 4, values.data()));
}

/// The range of lines or lanes of the ray frame that covers a range of the image.
struct Range
{
  std::ptrdiff_t Begin, End;
};

Range LinesOf(const RayFrame& frame, const GpuArea& area)
{
  const std::ptrdiff_t begin = frame.Columns ? area.X : area.Y;
  const std::ptrdiff_t end = begin + (frame.Columns ? area.Width : area.Height);
  return frame.Reversed ? Range{ frame.Lines - end, frame.Lines - begin } : Range{ begin, end };
}

} // namespace

GpuExact::GpuExact(GpuDevice& device, const GpuLimits& limits)
  : Device(device)
  , Limits(limits)
{
}

bool GpuExact::Load(const HeightField& field, std::uint64_t, const HorizonSettings& settings)
{
  if (!this->Pass)
  {
    this->Pass = std::make_unique<GpuPass>(
      this->Device, GpuText({ ShaderPart(skyline_GpuAngles), ShaderPart(skyline_GpuExact) }));
  }
  this->Field = &field;
  this->CurvatureDrop = settings.CurvatureDrop;
  this->Tile = GpuArea();
  this->Sheets.clear();
  const int limit = this->Device.ImageLimit();
  this->Side = this->Limits.Side > 0 ? std::min(this->Limits.Side, limit) : limit;
  if (this->Side < 2)
  {
    throw std::runtime_error("a texture holds fewer than two posts: raise the texture limit");
  }
  const int columns = static_cast<int>(field.Posts().Columns);
  const int rows = static_cast<int>(field.Posts().Rows);
  std::vector<float> values;
  for (int y = 0; y == 0 || y + 1 < rows; y += this->Side - 1)
  {
    for (int x = 0; x == 0 || x + 1 < columns; x += this->Side - 1)
    {
      Sheet sheet;
      sheet.Posts = { x, y, std::min(this->Side, columns - x), std::min(this->Side, rows - y) };
      values.clear();
      for (int row = y; row < y + sheet.Posts.Height; ++row)
      {
        const float* line = field.RowPlane().Line(row) + x;
        values.insert(values.end(), line, line + sheet.Posts.Width);
      }
      sheet.Heights =
        Checked(this->Device.Image(sheet.Posts.Width, sheet.Posts.Height, 1, values.data()));
      this->Sheets.push_back(sheet);
    }
  }
  return false;
}

void GpuExact::LoadTile(const GpuArea& tile)
{
  if (tile.X == this->Tile.X && tile.Y == this->Tile.Y && tile.Width == this->Tile.Width &&
    tile.Height == this->Tile.Height)
  {
    return;
  }
  std::vector<float> values, buffer;
  for (int row = tile.Y; row < tile.Y + tile.Height; ++row)
  {
    const float* line = this->Field->Receivers(false, row, buffer) + tile.X;
    values.insert(values.end(), line, line + tile.Width);
  }
  this->Receivers = Checked(this->Device.Image(tile.Width, tile.Height, 1, values.data()));
  this->Tile = tile;
}

void GpuExact::Find(const GpuArea& tile, const GpuArea& area, const Grid& grid,
  const std::vector<double>& azimuths, vtkTextureObject* horizons)
{
  this->LoadTile(tile);
  bool first = true;
  for (std::size_t channel = 0; channel < azimuths.size(); ++channel)
  {
    const RayFrame frame(*this->Field, grid, azimuths[channel], this->CurvatureDrop);
    const GpuTexture steps = StepTable(this->Device, frame);
    for (const Sheet& sheet : this->Sheets)
    {
      this->Walk(tile, area, frame, sheet, steps, static_cast<int>(channel), first, horizons);
      first = false;
    }
  }
}

void GpuExact::Walk(const GpuArea& tile, const GpuArea& area, const RayFrame& frame,
  const Sheet& sheet, vtkTextureObject* steps, int channel, bool first, vtkTextureObject* horizons)
{
  if (!this->Pass->Use())
  {
    throw std::runtime_error("OpenGL cannot build the shader of exact horizons");
  }
  // The steps at which a ray of the area can lie in the sheet.
  const GpuArea posts{ tile.X + area.X, tile.Y + area.Y, area.Width, area.Height };
  const Range from = LinesOf(frame, posts);
  const Range there = LinesOf(frame, sheet.Posts);
  const std::ptrdiff_t lane = frame.Columns ? posts.Y : posts.X;
  const std::ptrdiff_t begin = std::max<std::ptrdiff_t>(1, there.Begin - (from.End - 1));
  const std::ptrdiff_t end = std::min({ there.End - 1 - from.Begin, frame.Lines - 1,
    frame.LastStep(lane, frame.Columns ? posts.Height : posts.Width) });
  this->Pass->Set("heights", sheet.Heights);
  this->Pass->Set("place", sheet.Posts.X, sheet.Posts.Y);
  this->Pass->Set("size", sheet.Posts.Width, sheet.Posts.Height);
  this->Pass->Set("receivers", this->Receivers);
  this->Pass->Set("steps", steps);
  this->Pass->Set("tile", tile.X, tile.Y);
  this->Pass->Set("columns", frame.Columns ? 1 : 0);
  this->Pass->Set("forward", frame.Reversed ? -1 : 1);
  this->Pass->Set("drift", frame.Drift);
  this->Pass->Set("against", frame.Against ? 1 : 0);
  this->Pass->Set("first", static_cast<int>(begin));
  this->Pass->Set("last", static_cast<int>(end));
  this->Pass->Set("linesPerMetre", static_cast<float>(1.0 / frame.StepLength));
  this->Pass->Set("channel", channel);
  this->Pass->Draw({ horizons }, area, first ? GpuBlend::Replace : GpuBlend::Greatest);
}

} // namespace skyline
