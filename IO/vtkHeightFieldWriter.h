// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldWriter
 * @brief   writes point arrays of a height field as bands of a GeoTIFF
 *
 * Each component of each array becomes a band, north-up. The CRS and the geotransform are those in
 * the field data of the input, as vtkHeightFieldReader stores them. All bands have the narrowest
 * type that holds all arrays. Missing posts (NaN, infinite values) of float and double arrays
 * become the nodata value. This is the NodataValue in the field data of the input if no result can
 * have it (NaN, or a magnitude above 1000), else -9999, or NaN if a value is exactly that number.
 * The nodata value is declared if posts are missing or if the input declares one. Integer bands
 * have none.
 *
 * The file has DEFLATE compression with a predictor, tiles if it has more than 512 x 512 posts, and
 * bands one after the other. It is a BigTIFF if necessary. For errors and aborts see
 * vtkHeightFieldFileWriter.
 */
#ifndef vtkHeightFieldWriter_h
#define vtkHeightFieldWriter_h

#include "vtkHeightFieldFileWriter.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <map>    // for band texts
#include <string> // for array names
#include <vector> // for array names

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEIO_EXPORT vtkHeightFieldWriter : public vtkHeightFieldFileWriter
{
public:
  static vtkHeightFieldWriter* New();
  vtkTypeMacro(vtkHeightFieldWriter, vtkHeightFieldFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Adds the name of a point array to write. Bands have the order of the calls. Default: none,
   * which means the active scalars.
   */
  void AddArray(const char* name);
  void ClearArrays();
  ///@}

  ///@{
  /**
   * Description and unit of a band, counted from 1 over all arrays. By default the description is
   * the name of the array (with the name or number of the component if it has several), and the
   * unit is "m" for Elevation and ShadowHeight.
   */
  void SetBandDescription(int band, const char* text);
  void SetBandUnit(int band, const char* unit);
  ///@}

  /**
   * Removes all descriptions and units.
   */
  void ClearBandTexts();

  ///@{
  /**
   * Whether to write a cloud-optimized GeoTIFF: tiled, with overviews. Default: false.
   */
  vtkSetMacro(CloudOptimized, bool);
  vtkGetMacro(CloudOptimized, bool);
  vtkBooleanMacro(CloudOptimized, bool);
  ///@}

protected:
  vtkHeightFieldWriter();
  ~vtkHeightFieldWriter() override;

  void WriteImage(vtkImageData* image, const skyline::AtomicFile& file) override;

private:
  vtkHeightFieldWriter(const vtkHeightFieldWriter&) = delete;
  void operator=(const vtkHeightFieldWriter&) = delete;

  std::vector<std::string> ArrayNames;
  std::map<int, std::string> Descriptions;
  std::map<int, std::string> Units;
  bool CloudOptimized = false;
};
VTK_ABI_NAMESPACE_END

#endif
