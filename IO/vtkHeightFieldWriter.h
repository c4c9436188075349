// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldWriter
 * @brief   writes point arrays of a height field as bands of a GeoTIFF
 *
 * Every component of every array is a band, north-up, with the CRS and geotransform of the input's
 * field data, as vtkHeightFieldReader puts them there. The bands have the narrowest type that holds
 * all arrays.
 * Missing posts (NaN, infinities) of float and double arrays become the nodata value: the
 * NodataValue of the input's field data if no result can have it (NaN, or beyond 1000), else -9999,
 * else NaN where a height is that very number. A nodata value is declared if posts are missing or
 * the input declares one; integer bands have none.
 *
 * DEFLATE with a predictor, tiles for more than 512 x 512 posts, bands one after the other, BigTIFF
 * where needed. Errors and aborts: see vtkHeightFieldFileWriter.
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
   * The point arrays to write, in this order. None added: the active scalars.
   */
  void AddArray(const char* name);
  void ClearArrays();
  ///@}

  ///@{
  /**
   * Description and unit of a band, counted from 1 over all arrays. Default: the array's name (with
   * the component's name or number where there are several), and "m" for Elevation and
   * ShadowHeight.
   */
  void SetBandDescription(int band, const char* text);
  void SetBandUnit(int band, const char* unit);
  ///@}

  /**
   * Forgets all descriptions and units.
   */
  void ClearBandTexts();

  ///@{
  /**
   * Write a cloud-optimized GeoTIFF: tiled, with overviews. Default off.
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
