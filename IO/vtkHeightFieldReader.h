// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldReader
 * @brief   reads a band of any raster that GDAL can open as a height field
 *
 * The output is a two-dimensional vtkImageData with the point scalars "Elevation", in metres. A
 * post is the centre of a pixel. Row 0 is the southern edge and column 0 the western edge, whatever
 * the order in the file. Rotated and sheared rasters are refused.
 *
 * Spacing is in metres: the steps of the CRS or, if these are not true lengths, those on the ground
 * along the centre row (see Documentation/distances.md). Origin is the south-west post in CRS
 * coordinates, in metres, on a projected or local map, and 0 on a geographic one. Heights in feet,
 * with a scale and an offset, or with missing posts (nodata, mask, alpha, NaN, infinite values)
 * become float, or double if float would lose digits; missing posts are NaN. Other integers keep
 * their type. The unit of the heights is that of the band, else that of the vertical part of the
 * CRS, else metres. Heights are taken to count upwards even if the CRS says that they are depths.
 *
 * The field data hold the georeference of the requested extent; only that part of the file is read.
 * Spacing and RowSpacing are those of the whole raster, so that a result for a part equals the
 * result for the whole there. NodataValue is the value that the file declares for missing posts,
 * else the first finite value of AddNodata.
 *
 * Input that may not mean what it seems to mean is used with a warning (WarningEvent), which says
 * what was found, what is assumed, and how to change that. Examples are heights that look like
 * missing posts, a missing geotransform, degrees without a CRS, and contradictory units
 * (Documentation/input.md).
 *
 * A raster can name other files and servers: sources, masks, overviews. These names were chosen by
 * the author of the file and not by the user. Therefore only files in the folder of the raster and
 * below are read, only with drivers for local rasters, and nothing is read from the network.
 * AllowElsewhere, AllowNetwork and AddDriver permit more. A refusal is an error that names the file
 * and the option that allows it. See Documentation/untrusted-files.md.
 *
 * A pipe (/vsistdin/, /dev/stdin, a named pipe) is read once, into a temporary file that is kept
 * until FileName changes. A pipe that no program writes to is an error after ten seconds.
 *
 * What GDAL could not read on opening, for instance a CRS, is an error. Warnings of GDAL become
 * WarningEvents.
 *
 * A failure is reported by an ErrorEvent with one line that names the file, the value and the
 * remedy, and by an error code (GetErrorCode). After an abort the output is empty and the code is
 * vtkErrorCode::UserError.
 */
#ifndef vtkHeightFieldReader_h
#define vtkHeightFieldReader_h

#include "SkylineIOModule.h" // for the export macro
#include "vtkImageAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <memory> // for the private parts
#include <string>
#include <vector>

namespace skyline
{
struct SourcePolicy;
} // namespace skyline

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEIO_EXPORT vtkHeightFieldReader : public vtkImageAlgorithm
{
public:
  static vtkHeightFieldReader* New();
  vtkTypeMacro(vtkHeightFieldReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The raster to read: a path, or any other name that GDAL opens (/vsizip/..., NETCDF:...).
   * Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * The band that holds the heights, counted from 1. Default: 1.
   */
  vtkSetMacro(Band, int);
  vtkGetMacro(Band, int);
  ///@}

  ///@{
  /**
   * Values that mark missing posts in addition to the one that the file declares, as stored in the
   * band (before scale and unit). Any number is allowed; NaN and infinite values are always
   * missing. Default: none.
   */
  void AddNodata(double value);
  void RemoveAllNodata();
  int GetNumberOfNodata();
  double GetNodata(int index);
  ///@}

  ///@{
  /**
   * Whether data may be read from the network (URLs, /vsicurl/, /vsis3/ and the like), both by
   * FileName and by names inside the file. Default: false.
   */
  vtkSetMacro(AllowNetwork, bool);
  vtkGetMacro(AllowNetwork, bool);
  vtkBooleanMacro(AllowNetwork, bool);
  ///@}

  ///@{
  /**
   * Whether the file may refer to files outside its own folder, such as a virtual raster whose
   * tiles lie in another folder. Default: false.
   */
  vtkSetMacro(AllowElsewhere, bool);
  vtkGetMacro(AllowElsewhere, bool);
  vtkBooleanMacro(AllowElsewhere, bool);
  ///@}

  ///@{
  /**
   * Short names of further GDAL drivers, such as WMS, that may open the file and the files that it
   * refers to, in addition to those for local rasters. Drivers that read from servers also need
   * AllowNetwork. Default: none.
   */
  void AddDriver(const char* name);
  void RemoveAllDrivers();
  int GetNumberOfDrivers();
  const char* GetDriver(int index);
  ///@}

protected:
  vtkHeightFieldReader();
  ~vtkHeightFieldReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHeightFieldReader(const vtkHeightFieldReader&) = delete;
  void operator=(const vtkHeightFieldReader&) = delete;

  /// Runs `work`. If it throws, reports the error and returns false.
  template <typename Work>
  bool Try(const Work& work);

  /// The policy from the options, and the path of the copied bytes of a pipe (empty for other
  /// files).
  skyline::SourcePolicy MakePolicy() const;
  std::string Spool(const std::string& file);

  char* FileName = nullptr;
  int Band = 1;
  std::vector<double> Nodata;
  bool AllowNetwork = false;
  bool AllowElsewhere = false;
  struct Internal;
  std::unique_ptr<Internal> Parts;
};
VTK_ABI_NAMESPACE_END

#endif
