// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineLightMapReader
 * @brief   reads a Radiance (.hdr) or OpenEXR file as a light map
 *
 * The output is a two-dimensional vtkImageData with the point scalars "Radiance": three floats,
 * linear RGB, all finite and not negative. Row 0 of the image is the bottom of the map, at the
 * nadir, as VTK has it; the centre column is north, to the right is clockwise. The coordinates of a
 * point are the azimuth (x, -180 to 180 degrees) and the elevation (y, -90 to 90) of the pixel's
 * middle.
 *
 * A file is a latitude-longitude map if it has twice as many columns as rows. A cube has six square
 * faces in one image, seen from inside: 1 x 6 as OpenEXR stacks them (its Y axis up, its Z axis
 * north), 6 x 1 (east, west, up, down, north, south), or a cross of 4 x 3 or 3 x 4 with north in
 * the middle. A cube of n x n pixels a face becomes a map of 4 n x 2 n pixels that has its energy.
 *
 * Tiled and mip-mapped files are read at full resolution, the first part of several. Alpha is left
 * out; one channel is grey. Pixels that an OpenEXR file leaves out of its display window are black.
 * Negative values and NaN become 0, infinite ones the channel's largest finite value; the counts
 * below say of how many pixels, and a WarningEvent does. A sun stays as bright as it is.
 *
 * Only these two formats are read, by OpenImageIO's own readers of them, from regular files on the
 * local disk: no pipe, no URL. A file with more than 4096 x 2048 pixels must have a byte for every 64
 * of them, and none may have tiles or blocks of lines beyond 512 MB; see
 * Documentation/untrusted-files.md.
 *
 * A failure is one line through ErrorEvent, which names the file, the value and the cure, and an
 * error code (GetErrorCode). An abort leaves an empty output and the code vtkErrorCode::UserError.
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
   * The path of the file. Its first bytes say what it is, not its name.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * After Update: how many pixels of the file had a negative channel, one that was not a number,
   * and an infinite one.
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

  /// Runs `work`; false, with the error reported, if it throws.
  template <typename Work>
  bool Try(const Work& work);

  char* FileName = nullptr;
  vtkIdType NumberOfNegativePixels = 0;
  vtkIdType NumberOfNaNPixels = 0;
  vtkIdType NumberOfInfinitePixels = 0;
};
VTK_ABI_NAMESPACE_END

#endif
