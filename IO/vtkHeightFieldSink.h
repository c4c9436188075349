// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldSink
 * base class of the writers: a file appears either complete or not at all
 *
 * The input is a two-dimensional vtkImageData whose row 0 is the southern edge. The data are
 * written to a temporary file beside FileName, which is renamed on success, so that FileName is
 * never a partial file. On failure and on abort the temporary is removed. A file from which the
 * input was read, according to the field data of the reader, is never replaced. A failure is
 * reported by an ErrorEvent with one line that names the file, the value and the remedy, and by an
 * error code (GetErrorCode). After an abort the code is vtkErrorCode::UserError and nothing is
 * reported.
 */
#ifndef vtkHeightFieldSink_h
#define vtkHeightFieldSink_h

#include "SkylineIOModule.h" // for the export macro
#include "vtkImageAlgorithm.h"

#include <string> // for messages

class vtkDataArray;
class vtkImageData;

namespace skyline
{
class AtomicFile;
}

class SKYLINEIO_EXPORT vtkHeightFieldSink : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkHeightFieldSink, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The path of the file to write. An existing file is replaced. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Updates the input and writes the file. Returns 1 on success, else 0.
   */
  int Write();

protected:
  vtkHeightFieldSink();
  ~vtkHeightFieldSink() override;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /// Writes the whole image to `file.GetPath()` and closes it. Throws IoFailure or IoAborted.
  virtual void WriteImage(vtkImageData* image, const skyline::AtomicFile& file) = 0;

  /// Returns the point array `name` of the image, or its scalars if `name` is empty. Throws
  /// IoFailure with the available names if there is no such array.
  vtkDataArray* FindArray(vtkImageData* image, const std::string& name) const;

  /// Reports the completed part (0 to 1). Throws IoAborted if the user asked to stop.
  void Report(double part);

  /// Throws IoFailure: "cannot write 'FILE': reason".
  [[noreturn]] void Refuse(const std::string& reason) const;

  /// The extension of FileName in lower case, without the dot.
  std::string GetExtension() const;

private:
  vtkHeightFieldSink(const vtkHeightFieldSink&) = delete;
  void operator=(const vtkHeightFieldSink&) = delete;

  void Check(vtkImageData* image) const;

  char* FileName = nullptr;
  bool Written = false;
};

#endif
