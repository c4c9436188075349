// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineLightMapReader
 * @brief   reads a Radiance (.hdr) or OpenEXR file as a light map
 *
 * The output is a two-dimensional vtkImageData with the point scalars "Radiance": three floats,
 * linear RGB, all finite and not negative. Row 0 of the image is the bottom of the map (the nadir),
 * as usual in VTK. The centre column is north, and azimuths increase to the right. The coordinates
 * of a point are the azimuth (x, -180 to 180 degrees) and the elevation (y, -90 to 90 degrees) of
 * the centre of the pixel.
 *
 * A file is a latitude-longitude map if it has twice as many columns as rows. A cube has six square
 * faces in one image, seen from inside: 1 x 6 in the order of OpenEXR (its Y axis up, its Z axis
 * north), 6 x 1 (east, west, up, down, north, south), or a cross of 4 x 3 or 3 x 4 with north in
 * the middle. A cube with faces of n x n pixels becomes a map of 4 n x 2 n pixels with the same
 * energy.
 *
 * Tiled and mip-mapped files are read at full resolution. Of several parts, the first is read.
 * Alpha is ignored; a single channel is grey. Pixels of the display window that an OpenEXR file
 * does not contain are black. Negative values and NaN become 0, and infinite values become the
 * greatest finite value of their channel. A WarningEvent reports how many pixels were changed, and
 * so do the methods below. The brightness of a sun is not changed.
 *
 * Only these two formats are read, with OpenImageIO's readers, from regular files on a local disk;
 * pipes and URLs are refused. A file with more than 4096 x 2048 pixels must have at least one byte
 * for every 64 pixels, and tiles or blocks of lines must not exceed 512 MB. See
 * Documentation/untrusted-files.md.
 *
 * A failure is reported by an ErrorEvent with one line that names the file, the value and the
 * remedy, and by an error code (GetErrorCode). After an abort the output is empty and the code is
 * vtkErrorCode::UserError.
 */
#ifndef vtkSkylineLightMapReader_h
#define vtkSkylineLightMapReader_h

#include "SkylineIOModule.h" // for the export macro
#include "vtkImageAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEIO_EXPORT vtkSkylineLightMapReader : public vtkImageAlgorithm
{
public:
  static vtkSkylineLightMapReader* New();
  vtkTypeMacro(vtkSkylineLightMapReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The path of the file. The format is recognised by the first bytes, not by the extension.
   * Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * After Update, the number of pixels of the file with a negative channel, with one that is not a
   * number, and with an infinite one.
   */
  vtkGetMacro(NumberOfNegativePixels, vtkIdType);
  vtkGetMacro(NumberOfNaNPixels, vtkIdType);
  vtkGetMacro(NumberOfInfinitePixels, vtkIdType);
  ///@}

protected:
  vtkSkylineLightMapReader();
  ~vtkSkylineLightMapReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSkylineLightMapReader(const vtkSkylineLightMapReader&) = delete;
  void operator=(const vtkSkylineLightMapReader&) = delete;

  /// Runs `work`. If it throws, reports the error and returns false.
  template <typename Work>
  bool Try(const Work& work);

  char* FileName = nullptr;
  vtkIdType NumberOfNegativePixels = 0;
  vtkIdType NumberOfNaNPixels = 0;
  vtkIdType NumberOfInfinitePixels = 0;
};
VTK_ABI_NAMESPACE_END

#endif
