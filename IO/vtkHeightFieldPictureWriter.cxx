// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldPictureWriter.h"

#include "AtomicFile.h"
#include "CheckedFile.h"
#include "GeoTiffFile.h"
#include "NoImageThreads.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeightFieldPictureWriter);

namespace
{

constexpr float LargestHalf = 65504.0f;

/// OpenImageIO's progress function over Report, which may throw; the exception waits in here.
template <typename Report>
struct ProgressBridge
{
  Report Tell;
  std::exception_ptr Thrown;

  static bool Call(void* data, float part)
  {
    auto* self = static_cast<ProgressBridge*>(data);
    if (part <= 0.0f)
    {
      return false; // told before; libpng prints a complaint about files that it closes so soon
    }
    try
    {
      self->Tell(part);
      return false;
    }
    catch (...)
    {
      self->Thrown = std::current_exception();
      return true;
    }
  }
};

vtkSmartPointer<vtkDataArray> ToFloat(vtkDataArray* array, float largest)
{
  auto floats = vtkSmartPointer<vtkFloatArray>::New();
  floats->DeepCopy(array);
  float* values = floats->GetPointer(0);
  std::transform(values, values + floats->GetNumberOfValues(), values,
    [=](float value) { return value > largest ? largest : value; });
  return floats;
}

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
  skyline::CheckedFile File;
};

/// Pixels as they were handed to OpenImageIO: the first line is the picture's top.
struct Picture
{
  const char* Top = nullptr;
  OIIO::stride_t Line = 0; ///< bytes to the next line
  OIIO::TypeDesc Source, Stored;
  int Columns = 0, Rows = 0, Channels = 0;
};

/// Lines that are read back at a time.
constexpr int CheckedLines = 64;

/// Reads the file and compares every number. Throws IoFailure where one is another.
template <typename Report>
void CheckPicture(const Picture& picture, const skyline::AtomicFile& file, const Report& report)
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

vtkHeightFieldPictureWriter::vtkHeightFieldPictureWriter() = default;

vtkHeightFieldPictureWriter::~vtkHeightFieldPictureWriter()
{
  this->SetArrayName(nullptr);
}

vtkDataArray* vtkHeightFieldPictureWriter::FindPicture(
  vtkImageData* image, const std::string& extension) const
{
  vtkDataArray* array = this->FindArray(image, this->ArrayName ? this->ArrayName : "");
  const std::string name = array->GetName() ? array->GetName() : "(unnamed)";
  const int channels = array->GetNumberOfComponents();
  if (channels != 1 && channels != 3 && channels != 4)
  {
    this->Refuse("the array '" + name + "' has " + std::to_string(channels) +
      " components; give 1 (grey), 3 (RGB) or 4 (RGBA)");
  }
  const bool bytes = array->GetDataType() == VTK_UNSIGNED_CHAR;
  const bool real = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  const bool fits = extension == "png" ? bytes : extension == "exr" ? real : bytes || real;
  if (!fits)
  {
    this->Refuse("the array '" + name + "' is of type " + array->GetDataTypeAsString() +
      "; give unsigned char for .png, float for .exr, either for .tif");
  }
  return array;
}

void vtkHeightFieldPictureWriter::WriteImage(vtkImageData* image, const skyline::AtomicFile& file)
{
  const std::string extension = this->GetExtension();
  const bool tiff = extension == "tif" || extension == "tiff";
  if (extension != "png" && extension != "exr" && !tiff)
  {
    this->Refuse("a picture's name ends in .png, .exr or .tif");
  }
  vtkSmartPointer<vtkDataArray> array = this->FindPicture(image, extension);
  if (tiff)
  {
    this->WriteTiff(image, array, file);
    return;
  }
  const bool bytes = extension == "png";
  const bool half = this->HalfPrecision && !bytes;
  if (!bytes && (half || !vtkFloatArray::FastDownCast(array)))
  {
    array = ToFloat(array, half ? LargestHalf : std::numeric_limits<float>::infinity());
  }

  const int columns = image->GetDimensions()[0];
  const int rows = image->GetDimensions()[1];
  const int channels = array->GetNumberOfComponents();
  const OIIO::TypeDesc source = bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT;
  const OIIO::TypeDesc stored = half ? OIIO::TypeDesc(OIIO::TypeDesc::HALF) : source;
  this->Report(0.0);
  const skyline::NoImageThreads alone;
  CheckedProxy proxy(file.GetPath());
  const auto output = OIIO::ImageOutput::create(file.GetPath(), &proxy);
  if (!output)
  {
    file.Fail(OIIO::geterror());
  }
  output->threads(1);
  bool written = output->open(file.GetPath(), Describe(columns, rows, channels, stored));

  const OIIO::stride_t line = static_cast<OIIO::stride_t>(source.size()) * channels * columns;
  const char* south = static_cast<const char*>(array->GetVoidPointer(0));
  const auto report = [this](float part) { this->Report(0.9 * part); };
  ProgressBridge<decltype(report)> progress{ report, nullptr };
  written = written &&
    output->write_image(source, south + (rows - 1) * line, OIIO::AutoStride, -line,
      OIIO::AutoStride, &ProgressBridge<decltype(report)>::Call, &progress);
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
  CheckPicture({ south + (rows - 1) * line, -line, source, stored, columns, rows, channels }, file,
    [this](double part) { this->Report(0.9 + 0.1 * part); });
}

// By GDAL: it keeps the georeference, and where GDAL is loaded OpenImageIO's TIFFs fail, because
// both extend libtiff's tags.
void vtkHeightFieldPictureWriter::WriteTiff(
  vtkImageData* image, vtkDataArray* array, const skyline::AtomicFile& file)
{
  skyline::GeoTiffContent content = skyline::ContentOf(image);
  content.Picture = true;
  for (int component = 0; component < array->GetNumberOfComponents(); ++component)
  {
    content.Bands.push_back({ array, component, "", "" });
  }
  skyline::WriteGeoTiff(content, file, [this](double part) { this->Report(part); });
}

void vtkHeightFieldPictureWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << (this->ArrayName ? this->ArrayName : "(active scalars)") << "\n";
  os << indent << "HalfPrecision: " << (this->HalfPrecision ? "on" : "off") << "\n";
}
