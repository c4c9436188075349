// SPDX-License-Identifier: BSD-3-Clause
// Pictures, read back with GDAL (PNG and TIFF) or from the bytes of the file (EXR).
#include "IoTesting.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkHeightFieldPictureWriter.h"
#include "vtkPNGReader.h"
#include "vtkUnsignedCharArray.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>

using namespace skyline_test;

namespace
{

constexpr int Columns = 7, Rows = 5;

double Byte(int column, int row, int component)
{
  return column + 10 * row + 60 * component;
}

double Light(int column, int row, int component)
{
  return column == 0 ? 1e5 : 0.25 * Byte(column, row, component) - 1.0;
}

template <typename ArrayT>
vtkSmartPointer<vtkImageData> Image(
  int components, const std::function<double(int, int, int)>& value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Columns, Rows, 1);
  vtkNew<ArrayT> array;
  array->SetName("Colors");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(Columns * Rows);
  for (int i = 0; i < Columns * Rows; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      array->SetComponent(i, c, value(i % Columns, i / Columns, c));
    }
  }
  image->GetPointData()->SetScalars(array);
  return image;
}

std::string Write(vtkImageData* image, const std::string& name, bool half = false)
{
  const std::string path = OutputPath(name);
  vtkNew<vtkHeightFieldPictureWriter> writer;
  const Errors errors(writer);
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->SetHalfPrecision(half);
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(errors.First(), "");
  return path;
}

struct Picture
{
  OIIO::ImageSpec Spec;
  std::vector<float> Pixels;

  float At(int column, int line, int channel) const
  {
    return this->Pixels[static_cast<std::size_t>(
      (line * this->Spec.width + column) * this->Spec.nchannels + channel)];
  }
};

Picture ReadPicture(const std::string& file)
{
  Picture picture;
  const auto input = OIIO::ImageInput::open(file);
  EXPECT_NE(input, nullptr) << file;
  if (input)
  {
    picture.Spec = input->spec();
    picture.Pixels.resize(picture.Spec.image_pixels() * picture.Spec.nchannels);
    EXPECT_TRUE(input->read_image(
      0, 0, 0, picture.Spec.nchannels, OIIO::TypeDesc::FLOAT, picture.Pixels.data()));
  }
  return picture;
}

} // namespace

TEST(PictureWriter, PngKeepsItsBytesWithNorthOnTop)
{
  for (const int components : { 1, 3, 4 })
  {
    // Colours must not be multiplied by an alpha below 255.
    const auto value = [](int column, int row, int c)
    { return c == 3 ? 100.0 + column : Byte(column, row, c); };
    const std::string file = Write(Image<vtkUnsignedCharArray>(components, value), "bytes.png");
    vtkNew<vtkPNGReader> reader; // VTK's rows begin at the bottom, like those of Skyline
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    ASSERT_EQ(image->GetNumberOfScalarComponents(), components);
    ASSERT_EQ(image->GetScalarType(), VTK_UNSIGNED_CHAR);
    int wrong = 0;
    for (int row = 0; row < Rows; ++row)
    {
      for (int column = 0; column < Columns; ++column)
      {
        for (int c = 0; c < components; ++c)
        {
          wrong += image->GetScalarComponentAsDouble(column, row, 0, c) != value(column, row, c);
        }
      }
    }
    EXPECT_EQ(wrong, 0) << components;
  }
}

TEST(PictureWriter, ExrKeepsItsLight)
{
  const auto image = Image<vtkFloatArray>(3, Light);
  const Picture full = ReadPicture(Write(image, "light.exr"));
  EXPECT_EQ(full.Spec.format, OIIO::TypeDesc::FLOAT);
  const Picture half = ReadPicture(Write(image, "half.exr", true));
  EXPECT_EQ(half.Spec.format, OIIO::TypeDesc::HALF);
  for (int line = 0; line < Rows; ++line)
  {
    for (int column = 0; column < Columns; ++column)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double expected = Light(column, Rows - 1 - line, c);
        EXPECT_EQ(full.At(column, line, c), expected);
        EXPECT_EQ(half.At(column, line, c), std::min(expected, 65504.0)); // quarters fit in half
      }
    }
  }
}

TEST(PictureWriter, DoublesAreRoundedToFloat)
{
  const Picture picture = ReadPicture(Write(Image<vtkDoubleArray>(4, Light), "double.exr"));
  EXPECT_EQ(picture.Spec.nchannels, 4);
  EXPECT_EQ(picture.At(3, 0, 1), Light(3, Rows - 1, 1));
}

TEST(PictureWriter, TiffInTheArraysPrecision)
{
  const auto check = [](vtkImageData* image, GDALDataType type, double expected)
  {
    const std::string file = Write(image, "picture.tif");
    GDALAllRegister();
    GDALDataset* dataset = GDALDataset::Open(file.c_str(), GDAL_OF_RASTER);
    ASSERT_NE(dataset, nullptr);
    GDALRasterBand* green = dataset->GetRasterBand(2);
    EXPECT_EQ(dataset->GetRasterCount(), 3);
    EXPECT_EQ(green->GetRasterDataType(), type);
    EXPECT_EQ(green->GetColorInterpretation(), GCI_GreenBand);
    double value = 0.0;
    EXPECT_EQ(
      green->RasterIO(GF_Read, 2, 0, 1, 1, &value, 1, 1, GDT_Float64, 0, 0, nullptr), CE_None);
    EXPECT_EQ(value, expected);
    GDALClose(dataset);
  };
  check(Image<vtkUnsignedCharArray>(3, Byte), GDT_Byte, Byte(2, Rows - 1, 1));
  check(Image<vtkFloatArray>(3, Light), GDT_Float32, Light(2, Rows - 1, 1));
}

TEST(PictureWriter, PngSaysThatItIsSrgb)
{
  const Picture picture = ReadPicture(Write(Image<vtkUnsignedCharArray>(3, Byte), "srgb.png"));
  EXPECT_EQ(picture.Spec.get_string_attribute("oiio:ColorSpace"), "sRGB");
}

TEST(PictureWriter, ComponentsThatAreNoColour)
{
  vtkNew<vtkHeightFieldPictureWriter> writer;
  const Errors errors(writer);
  const auto image = Image<vtkUnsignedCharArray>(2, Byte);
  writer->SetInputData(image);
  writer->SetFileName(OutputPath("two.png").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_NE(
    errors.First().find("2 components; give 1 (grey), 3 (RGB) or 4 (RGBA)"), std::string::npos);
}
