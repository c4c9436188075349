// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldPictureWriter.h"

#include "AtomicFile.h"
#include "GeoTiffFile.h"
#include "ImageLibrary.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>
#include <string>

vtkStandardNewMacro(vtkHeightFieldPictureWriter);

namespace
{

constexpr float LargestHalf = 65504.0f;

vtkSmartPointer<vtkDataArray> ToFloat(vtkDataArray* array, float largest)
{
  auto floats = vtkSmartPointer<vtkFloatArray>::New();
  floats->DeepCopy(array);
  float* values = floats->GetPointer(0);
  std::transform(values, values + floats->GetNumberOfValues(), values,
    [=](float value) { return value > largest ? largest : value; });
  return floats;
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

  this->Report(0.0);
  skyline::Picture picture;
  picture.Values = array->GetVoidPointer(0);
  picture.Columns = image->GetDimensions()[0];
  picture.Rows = image->GetDimensions()[1];
  picture.Channels = array->GetNumberOfComponents();
  picture.Bytes = bytes;
  picture.Half = half;
  skyline::ImageLibrary::Get().WritePicture(
    picture, file, [this](double part) { this->Report(part); });
}

// GDAL writes TIFF pictures: it keeps the georeference, and OpenImageIO's TIFF code fails in a
// process that has loaded GDAL, because both extend libtiff's tags.
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
