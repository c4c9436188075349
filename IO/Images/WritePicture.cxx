// SPDX-License-Identifier: BSD-3-Clause
#include "WritePicture.h"

#include "AtomicFile.h"
#include "CheckedFile.h"
#include "NoImageThreads.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <string>
#include <vector>

namespace skyline
{

namespace
{

/// The share of writing in the total progress; the rest is reading the picture back.
constexpr double WritingPart = 0.9;

/// Passes OpenImageIO's progress to ReportFunction, which may throw. The exception is stored here
/// until OpenImageIO returns.
struct ProgressBridge
{
  const ImageLibrary::ReportFunction& Tell;
  std::exception_ptr Thrown;

  static bool Call(void* data, float part)
  {
    auto* self = static_cast<ProgressBridge*>(data);
    if (part <= 0.0f)
    {
      return false; // 0 was reported before; libpng prints a warning if it must stop this early
    }
    try
    {
      self->Tell(WritingPart * part);
      return false;
    }
    catch (...)
    {
      self->Thrown = std::current_exception();
      return true;
    }
  }
};

/// CheckedFile for OpenImageIO.
class CheckedProxy : public OIIO::Filesystem::IOProxy
{
public:
  explicit CheckedProxy(const std::string& path)
    : IOProxy(path, Write)
    , File(path, "w+")
  {
  }

  const char* proxytype() const override { return "checked"; }
  std::size_t size() const override { return static_cast<std::size_t>(this->File.GetSize()); }

  std::size_t pread(void* bytes, std::size_t size, std::int64_t offset) override
  {
    return this->File.Read(bytes, size, offset);
  }

  std::size_t pwrite(const void* bytes, std::size_t size, std::int64_t offset) override
  {
    this->File.Write(bytes, size, offset);
    return size;
  }

  std::size_t read(void* bytes, std::size_t size) override
  {
    const std::size_t done = this->pread(bytes, size, this->m_pos);
    this->m_pos += static_cast<std::int64_t>(done);
    return done;
  }

  std::size_t write(const void* bytes, std::size_t size) override
  {
    this->pwrite(bytes, size, this->m_pos);
    this->m_pos += static_cast<std::int64_t>(size);
    return size;
  }

  int Finish()
  {
    this->File.Close();
    return this->File.GetError();
  }

private:
  CheckedFile File;
};

/// Pixels in the order that OpenImageIO needs: the first line is the top of the picture.
struct Pixels
{
  const char* Top = nullptr;
  OIIO::stride_t Line = 0; ///< bytes to the next line
  OIIO::TypeDesc Source, Stored;
  int Columns = 0, Rows = 0, Channels = 0;
};

/// Number of lines that are read back at a time.
constexpr int CheckedLines = 64;

/// Reads the file and compares each number. Throws IoFailure if one differs.
void CheckPicture(
  const Pixels& picture, const AtomicFile& file, const ImageLibrary::ReportFunction& report)
{
  const std::string different =
    "the picture is not what was written; the memory or the disk may be at fault";
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(file.GetPath(), &config);
  if (!input)
  {
    file.Fail("the picture cannot be read back: " + OIIO::geterror());
  }
  input->threads(1);
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width != picture.Columns || spec.height != picture.Rows ||
    spec.nchannels != picture.Channels || spec.format != picture.Stored)
  {
    file.Fail(different);
  }
  const int values = picture.Columns * picture.Channels;
  const std::size_t lineBytes = static_cast<std::size_t>(values) * picture.Stored.size();
  std::vector<char> wanted(lineBytes), stored(lineBytes * CheckedLines);
  for (int row = 0; row < picture.Rows; row += CheckedLines)
  {
    const int end = std::min(row + CheckedLines, picture.Rows);
    if (!input->read_scanlines(
          0, 0, row, end, 0, 0, picture.Channels, picture.Stored, stored.data()))
    {
      file.Fail("the picture cannot be read back: " + input->geterror());
    }
    for (int line = row; line < end; ++line)
    {
      OIIO::convert_pixel_values(
        picture.Source, picture.Top + line * picture.Line, picture.Stored, wanted.data(), values);
      const char* found = stored.data() + static_cast<std::size_t>(line - row) * lineBytes;
      if (!std::equal(wanted.begin(), wanted.end(), found))
      {
        file.Fail(different);
      }
    }
    report(static_cast<double>(end) / picture.Rows);
  }
}

OIIO::ImageSpec Describe(int columns, int rows, int channels, const OIIO::TypeDesc& type)
{
  OIIO::ImageSpec spec(columns, rows, channels, type);
  spec.attribute("compression", "zip");
  if (type == OIIO::TypeDesc::UINT8)
  {
    spec.attribute("oiio:ColorSpace", "sRGB");
  }
  if (channels == 4 && type == OIIO::TypeDesc::UINT8)
  {
    spec.attribute("oiio:UnassociatedAlpha", 1);
  }
  return spec;
}

} // namespace

void WritePicture(
  const Picture& picture, const AtomicFile& file, const ImageLibrary::ReportFunction& report)
{
  Pixels pixels;
  pixels.Source = picture.Bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT;
  pixels.Stored = picture.Half ? OIIO::TypeDesc(OIIO::TypeDesc::HALF) : pixels.Source;
  pixels.Columns = picture.Columns;
  pixels.Rows = picture.Rows;
  pixels.Channels = picture.Channels;
  const OIIO::stride_t line =
    static_cast<OIIO::stride_t>(pixels.Source.size()) * picture.Channels * picture.Columns;
  pixels.Top = static_cast<const char*>(picture.Values) + (picture.Rows - 1) * line;
  pixels.Line = -line;

  const NoImageThreads alone;
  CheckedProxy proxy(file.GetPath());
  const auto output = OIIO::ImageOutput::create(file.GetPath(), &proxy);
  if (!output)
  {
    file.Fail(OIIO::geterror());
  }
  output->threads(1);
  bool written = output->open(
    file.GetPath(), Describe(picture.Columns, picture.Rows, picture.Channels, pixels.Stored));
  ProgressBridge progress{ report, nullptr };
  written = written &&
    output->write_image(pixels.Source, pixels.Top, OIIO::AutoStride, pixels.Line, OIIO::AutoStride,
      &ProgressBridge::Call, &progress);
  std::string reason = output->geterror();
  written = output->close() && written;
  reason += output->geterror();

  if (progress.Thrown)
  {
    std::rethrow_exception(progress.Thrown);
  }
  if (const int error = proxy.Finish())
  {
    file.Fail(error);
  }
  if (!written || !reason.empty())
  {
    file.Fail(reason);
  }
  CheckPicture(
    pixels, file, [&](double part) { report(WritingPart + (1.0 - WritingPart) * part); });
}

} // namespace skyline
