// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldPictureWriter
 * @brief   writes an RGB or RGBA point array as a picture
 *
 * The extension of FileName chooses the format:
 * - .png: 8-bit sRGB, from an unsigned char array;
 * - .exr: linear light, from a float or double array, as 32-bit or 16-bit floats;
 * - .tif: either, in the array's own precision, with the image's georeference.
 *
 * The top line of the picture is the image's last row (north). Numbers are never changed: whoever
 * makes the array decides on exposure and transfer curve. Alpha is not multiplied into 8-bit colour
 * and is multiplied into linear colour. Errors and aborts: see vtkHeightFieldFileWriter.
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
   * The point array with 1 (grey), 3 (RGB) or 4 (RGBA) components. None: the active scalars.
   */
  vtkSetStringMacro(ArrayName);
  vtkGetStringMacro(ArrayName);
  ///@}

  ///@{
  /**
   * Write EXR with 16-bit floats, which end at 65504: greater values become that. Default off.
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
