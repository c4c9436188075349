// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldPictureWriter
 * @brief   writes an RGB or RGBA point array as a picture
 *
 * The extension of FileName selects the format:
 * - .png: 8-bit sRGB, from an array of unsigned char.
 * - .exr: linear light, from an array of float or double, written as 32-bit or 16-bit floats.
 * - .tif: either kind of array, in its own precision, with the georeference of the image.
 *
 * The top line of the picture is the last row of the image (north). The numbers are written
 * unchanged; exposure and transfer curve must already be applied. 8-bit colour must not be
 * premultiplied by alpha, and linear colour must be. For errors and aborts see
 * vtkHeightFieldFileWriter.
 */
#ifndef vtkHeightFieldPictureWriter_h
#define vtkHeightFieldPictureWriter_h

#include "vtkHeightFieldFileWriter.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEIO_EXPORT vtkHeightFieldPictureWriter : public vtkHeightFieldFileWriter
{
public:
  static vtkHeightFieldPictureWriter* New();
  vtkTypeMacro(vtkHeightFieldPictureWriter, vtkHeightFieldFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the point array to write, with 1 (grey), 3 (RGB) or 4 (RGBA) components. Default: none,
   * which means the active scalars.
   */
  vtkSetStringMacro(ArrayName);
  vtkGetStringMacro(ArrayName);
  ///@}

  ///@{
  /**
   * Whether .exr files have 16-bit floats. Values above 65504, the greatest such float, become
   * 65504. Default: false.
   */
  vtkSetMacro(HalfPrecision, bool);
  vtkGetMacro(HalfPrecision, bool);
  vtkBooleanMacro(HalfPrecision, bool);
  ///@}

protected:
  vtkHeightFieldPictureWriter();
  ~vtkHeightFieldPictureWriter() override;

  void WriteImage(vtkImageData* image, const skyline::AtomicFile& file) override;

private:
  vtkHeightFieldPictureWriter(const vtkHeightFieldPictureWriter&) = delete;
  void operator=(const vtkHeightFieldPictureWriter&) = delete;

  vtkDataArray* FindPicture(vtkImageData* image, const std::string& extension) const;
  void WriteTiff(vtkImageData* image, vtkDataArray* array, const skyline::AtomicFile& file);

  char* ArrayName = nullptr;
  bool HalfPrecision = false;
};
VTK_ABI_NAMESPACE_END

#endif
