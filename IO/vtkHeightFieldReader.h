// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldReader
 * @brief   reads a band of any raster that GDAL opens as a height field
 *
 * The output is a two-dimensional vtkImageData with the point scalars "Elevation", in metres. A
 * post is a pixel centre. Row 0 is the south edge and column 0 the west edge, whichever way the
 * file runs; rotated and sheared rasters are refused.
 *
 * Spacing is in metres: the CRS's steps, or the true ones of the centre row where they differ (see
 * Documentation/distances.md). Origin is the south-west post's CRS coordinates in metres on a projected or local
 * map, and 0 on a geographic one. Heights in feet, with a scale and an offset, or with missing
 * posts (nodata, mask, alpha, NaN, infinities) become float, or double where float would lose
 * digits, with NaN for the missing; other integers stay as they are. The unit of the heights is the
 * band's, else that of the CRS's vertical part, else metres; heights count upwards even where the
 * CRS speaks of depths.
 *
 * Field data carries the georeference of the extent that was delivered,
 * which is the extent asked for: only that part of the file is read. Spacing and RowSpacing are the
 * whole raster's, so that a part is what the whole has there. NodataValue is the value the file
 * declares for missing posts, else the first finite one of AddNodata.
 *
 * Input that may not mean what it seems to mean is read as it stands, with a warning (WarningEvent) of
 * what was found, what is assumed, and the cure: heights that look like missing posts, no geotransform,
 * degrees without a CRS, units that contradict each other (Documentation/input.md).
 *
 * A raster can name other files and servers: sources, masks, overviews. Such names are the file's and
 * not the user's, so that only files in its own folder and below are read, by drivers of local rasters
 * (skyline::DefaultDrivers), and nothing from the network. AllowElsewhere, AllowNetwork and AddDriver
 * widen that; what is refused is an error that names it and the way to allow it. See
 * Documentation/untrusted-files.md.
 *
 * A pipe (/vsistdin/, /dev/stdin, a named pipe) is read once, into a temporary file, for as long as
 * the reader has that name. A pipe that nobody writes is an error after ten seconds.
 *
 * What GDAL could not make out on opening, a CRS for instance, is an error; what it warns about is a
 * WarningEvent.
 *
 * A failure is one line through ErrorEvent, which names the file, the value and the cure, and an
 * error code (GetErrorCode). An abort leaves an empty output and the code vtkErrorCode::UserError.
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
   * What to read: a path, or any other name that GDAL opens (/vsizip/..., NETCDF:...).
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Which band holds the heights, from 1. Default 1.
   */
  vtkSetMacro(Band, int);
  vtkGetMacro(Band, int);
  ///@}

  ///@{
  /**
   * Values of missing posts besides the one that the file declares, as the band has them (before its
   * scale and unit); any number, NaN and infinities (which are missing anyway) too. Default: none.
   */
  void AddNodata(double value);
  void RemoveAllNodata();
  int GetNumberOfNodata();
  double GetNodata(int index);
  ///@}

  ///@{
  /**
   * Whether files from the network may be read: URLs, /vsicurl/, /vsis3/ and the like, whether the
   * user named them or the file does. Default false.
   */
  vtkSetMacro(AllowNetwork, bool);
  vtkGetMacro(AllowNetwork, bool);
  vtkBooleanMacro(AllowNetwork, bool);
  ///@}

  ///@{
  /**
   * Whether the file may lead to files outside its own folder, as a virtual raster over tiles in
   * another folder does. Default false.
   */
  vtkSetMacro(AllowElsewhere, bool);
  vtkGetMacro(AllowElsewhere, bool);
  vtkBooleanMacro(AllowElsewhere, bool);
  ///@}

  ///@{
  /**
   * Further drivers of GDAL that may open the file and what it leads to, by their short names (WMS),
   * beside those of local rasters. Drivers that read from servers need AllowNetwork too. Default none.
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

  /// Runs `work`; false, with the error reported, if it throws.
  template <typename Work>
  bool Try(const Work& work);

  /// The policy, and where the bytes of a pipe are (empty: the file is none).
  skyline::SourcePolicy MakePolicy() const;
  std::string Spool(const std::string& file);

  char* FileName = nullptr;
  int Band = 1;
  std::vector<double> Nodata;
  bool AllowNetwork = false;
  bool AllowElsewhere = false;
  struct Inside;
  std::unique_ptr<Inside> Parts;
};
VTK_ABI_NAMESPACE_END

#endif
