// SPDX-License-Identifier: BSD-3-Clause
#include "OpenLightMap.h"

#include "IoFailure.h"
#include "NoImageThreads.h"
#include "Sky/CubeMap.h"

#include "vtkErrorCode.h"
#include "vtkSMPTools.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

namespace skyline
{

namespace
{

/// OpenImageIO's name of the format that the first bytes of the file indicate, or "". With a name,
/// OpenImageIO tries no other format. Its TIFF reader, for one, does not work in a process that has
/// loaded GDAL.
std::string FindFormat(const std::array<char, 4>& start)
{
  const std::array<char, 4> openExr{ '\x76', '\x2f', '\x31', '\x01' };
  if (start == openExr)
  {
    return "openexr";
  }
  return start[0] == '#' && start[1] == '?' ? "hdr" : "";
}

/// The error text of OpenImageIO as a part of a sentence.
std::string Reason(const std::string& error)
{
  const std::string line = FirstLine(error);
  return line.substr(0, line.find_last_not_of(". ") + 1);
}

/// The greatest number of pixels of a file and of its display window: 32768 x 16384.
constexpr std::int64_t MostPixels = std::int64_t(1) << 29;

/// A map of up to 4096 x 2048 pixels is accepted whatever its file size. A larger one may have at
/// most MostPixelsPerByte pixels for each byte of the file. Measured skies have more than one byte
/// per pixel, computed ones more than a twentieth of a byte.
constexpr std::int64_t BelievedPixels = std::int64_t(4096) * 2048;
constexpr std::int64_t MostPixelsPerByte = 64;

/// The greatest size of a tile or block of lines, which OpenEXR keeps in memory as a whole. A block
/// of 256 lines of 32768 half-precision RGBA pixels has 64 MB.
constexpr double MostChunkBytes = 512.0 * 1024 * 1024;

/// The greatest number of lines that OpenEXR compresses together.
constexpr double MostChunkLines = 256.0;

std::string Dimensions(int columns, int rows)
{
  return std::to_string(columns) + " x " + std::to_string(rows);
}

/// Passes OpenImageIO's progress to our function. An exception is stored here until OpenImageIO
/// returns.
struct ProgressBridge
{
  const LightMapFile::ProgressFunction& Tell;
  bool Stopped = false;
  std::exception_ptr Thrown;

  static bool Call(void* data, float part)
  {
    auto* self = static_cast<ProgressBridge*>(data);
    try
    {
      self->Stopped = self->Stopped || !self->Tell(part);
    }
    catch (...)
    {
      self->Thrown = std::current_exception();
      self->Stopped = true;
    }
    return self->Stopped;
  }
};

/// A light map read with OpenImageIO.
class ImageLightMap : public LightMapFile
{
public:
  explicit ImageLightMap(const std::string& file);

  int GetColumns() const override { return this->Columns; }
  int GetRows() const override { return this->Rows; }
  bool IsCube() const override { return this->Cube; }
  LightMapDefects Read(float* pixels, const ProgressFunction& progress) override;

private:
  void Open();
  void FindChannels();
  void FindShape();
  void CheckFileSize(std::int64_t pixels) const;
  std::unique_ptr<float[]> ReadPixels(const ProgressFunction& progress);
  void PlaceInWindow(const float* values, float* pixels) const;
  [[noreturn]] void Refuse(const std::string& reason) const;

  std::string File;
  NoImageThreads Alone;
  std::unique_ptr<OIIO::ImageInput> Input;
  OIIO::ImageSpec Spec; ///< of the first part, at full resolution
  int FirstChannel = 0;
  int Channels = 3; ///< 1 (grey) or 3
  int Columns = 0, Rows = 0;
  bool Cube = false;
  CubeMap Faces; ///< the layout of a cube, without values
};

ImageLightMap::ImageLightMap(const std::string& file)
  : File(file)
{
  this->Open();
  this->FindChannels();
  this->FindShape();
}

void ImageLightMap::Refuse(const std::string& reason) const
{
  throw IoFailure(vtkErrorCode::FileFormatError, "cannot use '" + this->File + "': " + reason);
}

void ImageLightMap::Open()
{
  std::error_code status;
  if (std::filesystem::is_directory(this->File, status))
  {
    throw IoFailure(vtkErrorCode::CannotOpenFileError,
      "cannot read '" + this->File + "': it is a folder; give a .hdr or .exr file");
  }
  if (std::filesystem::is_other(this->File, status))
  {
    // The file is read forwards and backwards, and a pipe that nobody writes would block forever.
    throw IoFailure(vtkErrorCode::CannotOpenFileError,
      "cannot read '" + this->File + "': it is a pipe or a device; give a .hdr or .exr file");
  }
  std::array<char, 4> start{};
  std::size_t size = 0;
  std::FILE* stream = std::fopen(this->File.c_str(), "rb");
  if (!stream)
  {
    const int reason = errno;
    throw IoFailure(
      reason == ENOENT ? vtkErrorCode::FileNotFoundError : vtkErrorCode::CannotOpenFileError,
      "cannot read '" + this->File + "': " + std::strerror(reason) + "; check the path");
  }
  size = std::fread(start.data(), 1, start.size(), stream);
  std::fclose(stream);

  const std::string format = FindFormat(start);
  if (size == 0 || format.empty())
  {
    throw IoFailure(vtkErrorCode::UnrecognizedFileTypeError,
      "cannot read '" + this->File +
        "': " + (size == 0 ? "it is empty" : "it is neither a Radiance nor an OpenEXR image") +
        "; give a .hdr or .exr file");
  }
  this->Input = OIIO::ImageInput::create(format);
  if (!this->Input)
  {
    throw IoFailure(vtkErrorCode::UnrecognizedFileTypeError,
      "cannot read '" + this->File + "': " + Reason(OIIO::geterror()) +
        "; install OpenImageIO with its formats");
  }
  this->Input->threads(1);
  if (!this->Input->open(this->File, this->Spec))
  {
    throw IoFailure(vtkErrorCode::FileFormatError,
      "cannot read '" + this->File + "': " + Reason(this->Input->geterror()) +
        "; the file may be damaged, fetch it again");
  }
}

void ImageLightMap::FindChannels()
{
  if (this->Spec.deep || this->Spec.depth > 1)
  {
    this->Refuse("it is a deep or three-dimensional image; give a flat one");
  }
  if (this->Spec.get_int_attribute("Orientation", 1) != 1)
  {
    this->Refuse("its rows do not run from left to right and top to bottom (orientation " +
      std::to_string(this->Spec.get_int_attribute("Orientation", 1)) + "); turn the image upright");
  }
  // The first three consecutive channels R, G, B, of any layer ("diffuse.R").
  const auto ends = [this](int channel, const char* letter)
  {
    const std::string& name = this->Spec.channelnames[static_cast<std::size_t>(channel)];
    const std::size_t dot = name.rfind('.');
    return name.substr(dot == std::string::npos ? 0 : dot + 1) == letter;
  };
  const int channels = this->Spec.nchannels;
  for (int first = 0; first + 2 < channels; ++first)
  {
    if (ends(first, "R") && ends(first + 1, "G") && ends(first + 2, "B"))
    {
      this->FirstChannel = first;
      return;
    }
  }
  const bool alpha = channels == 2 && this->Spec.alpha_channel == 1;
  if (channels == 1 || alpha)
  {
    this->Channels = 1;
    return;
  }
  std::string names;
  for (const std::string& name : this->Spec.channelnames)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  this->Refuse("it has the channels " + names + "; give R, G, B or a single one");
}

void ImageLightMap::FindShape()
{
  const OIIO::ImageSpec& spec = this->Spec;
  if (spec.width < 1 || spec.height < 1)
  {
    this->Refuse("it has " + Dimensions(spec.width, spec.height) +
      " pixels; give a latitude-longitude map, such as 1024 x 512");
  }
  const std::int64_t pixels = static_cast<std::int64_t>(spec.width) * spec.height;
  const std::int64_t full = static_cast<std::int64_t>(spec.full_width) * spec.full_height;
  if (std::max(pixels, full) > MostPixels)
  {
    this->Refuse("it has " + Dimensions(spec.width, spec.height) +
      " pixels; give a map of 32768 x 16384 at most");
  }
  this->CheckFileSize(std::max(pixels, full));
  // If the display window has twice as many columns as rows, it is the whole sphere, and the pixels
  // may be a part of it.
  if (spec.full_width > 0 && spec.full_width == 2 * spec.full_height)
  {
    this->Columns = spec.full_width;
    this->Rows = spec.full_height;
    return;
  }
  if (spec.width == 2 * spec.height)
  {
    this->Spec.full_x = spec.x; // a display window of another shape is ignored
    this->Spec.full_y = spec.y;
    this->Columns = spec.width;
    this->Rows = spec.height;
    return;
  }
  std::ptrdiff_t size = 0;
  if (!FindCubeLayout(spec.width, spec.height, this->Faces.Layout, size))
  {
    this->Refuse("it has " + Dimensions(spec.width, spec.height) +
      " pixels; give a latitude-longitude map (2:1) or a cube (1:6, 6:1, 4:3 or 3:4)");
  }
  this->Cube = true;
  this->Faces.Size = size;
  this->Columns = static_cast<int>(4 * size);
  this->Rows = static_cast<int>(2 * size);
}

/// Refuses a file that is too small for its number of pixels: a header of a few bytes may announce
/// gigabytes.
void ImageLightMap::CheckFileSize(std::int64_t pixels) const
{
  std::error_code status;
  const auto bytes = static_cast<std::int64_t>(std::filesystem::file_size(this->File, status));
  if (!status && pixels > BelievedPixels && pixels / MostPixelsPerByte > bytes)
  {
    this->Refuse("it has " + std::to_string(bytes) + " bytes for " + std::to_string(pixels) +
      " pixels, beyond " + std::to_string(MostPixelsPerByte) +
      " pixels per byte; give a map of 4096 x 2048 at most, or save it without compression");
  }
  const OIIO::ImageSpec& spec = this->Spec;
  const double chunk = spec.tile_width > 0
    ? static_cast<double>(spec.tile_width) * spec.tile_height
    : spec.width * std::min<double>(spec.height, MostChunkLines);
  const double chunkBytes = chunk * static_cast<double>(spec.pixel_bytes(true));
  if (chunkBytes > MostChunkBytes)
  {
    this->Refuse("its " + std::string(spec.tile_width > 0 ? "tiles" : "blocks of lines") +
      " with " + std::to_string(spec.nchannels) + " channels take " +
      std::to_string(static_cast<std::int64_t>(chunkBytes / (1024 * 1024))) +
      " MB each, and 512 are allowed; save it with R, G, B alone, in lines");
  }
}

std::unique_ptr<float[]> ImageLightMap::ReadPixels(const ProgressFunction& progress)
{
  const std::size_t count = static_cast<std::size_t>(this->Spec.width) * this->Spec.height;
  // The memory is not filled, because a damaged header may announce gigabytes that the file does
  // not hold.
  std::unique_ptr<float[]> values(new float[3 * count]);
  ProgressBridge bridge{ progress, false, nullptr };
  const bool read = this->Input->read_image(0, 0, this->FirstChannel,
    this->FirstChannel + this->Channels, OIIO::TypeDesc::FLOAT, values.get(), 3 * sizeof(float),
    OIIO::AutoStride, OIIO::AutoStride, &ProgressBridge::Call, &bridge);
  if (bridge.Thrown)
  {
    std::rethrow_exception(bridge.Thrown);
  }
  if (bridge.Stopped)
  {
    throw IoAborted();
  }
  if (!read)
  {
    throw IoFailure(vtkErrorCode::PrematureEndOfFileError,
      "cannot read the pixels of '" + this->File + "': " + Reason(this->Input->geterror()) +
        "; the file may be damaged, fetch it again");
  }
  if (this->Channels == 1)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      values[3 * i + 2] = values[3 * i + 1] = values[3 * i];
    }
  }
  return values;
}

/// Copies the rows of the file, from the top, to rows of the map, from the bottom.
void ImageLightMap::PlaceInWindow(const float* values, float* pixels) const
{
  const OIIO::ImageSpec& spec = this->Spec;
  const int right = spec.x - spec.full_x, below = spec.y - spec.full_y;
  const int begin = std::max(0, -right), end = std::min(spec.width, this->Columns - right);
  std::fill_n(pixels, 3 * static_cast<std::ptrdiff_t>(this->Columns) * this->Rows, 0.0f);
  for (int line = std::max(0, -below); line < std::min(spec.height, this->Rows - below); ++line)
  {
    const float* from = values + 3 * static_cast<std::ptrdiff_t>(spec.width) * line;
    float* to =
      pixels + 3 * static_cast<std::ptrdiff_t>(this->Columns) * (this->Rows - 1 - line - below);
    if (begin < end)
    {
      std::copy(from + 3 * begin, from + 3 * end, to + 3 * (begin + right));
    }
  }
}

LightMapDefects ImageLightMap::Read(float* pixels, const ProgressFunction& progress)
{
  const std::unique_ptr<float[]> values = this->ReadPixels(progress);
  const LightMapDefects defects = SanitizeLightMap(
    values.get(), static_cast<std::ptrdiff_t>(this->Spec.width) * this->Spec.height);
  if (!this->Cube)
  {
    this->PlaceInWindow(values.get(), pixels);
    return defects;
  }

  CubeMap cube = this->Faces;
  cube.Values = values.get();
  cube.RowStride = 3 * static_cast<std::ptrdiff_t>(this->Spec.width);
  if (!UnusedPixelsAlike(cube))
  {
    this->Refuse("it has " + Dimensions(this->Spec.width, this->Spec.height) +
      " pixels, but they are not a cross of cube faces; give a latitude-longitude map (2:1) or a "
      "cube");
  }
  const std::ptrdiff_t columns = this->Columns, rows = this->Rows;
  vtkSMPTools::For(0, rows,
    [&](vtkIdType begin, vtkIdType end)
    { CubeToLightMap(cube, columns, rows, begin, end, pixels); });
  KeepEnergy(CubeEnergy(cube), columns, rows, pixels);
  for (std::ptrdiff_t row = 0; row < rows / 2; ++row)
  {
    std::swap_ranges(pixels + 3 * columns * row, pixels + 3 * columns * (row + 1),
      pixels + 3 * columns * (rows - 1 - row));
  }
  return defects;
}

} // namespace

std::unique_ptr<LightMapFile> OpenLightMap(const std::string& file)
{
  return std::make_unique<ImageLightMap>(file);
}

} // namespace skyline
