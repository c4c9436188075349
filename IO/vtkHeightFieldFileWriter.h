// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldFileWriter
 * @brief   writes a height field to a file, complete or not at all
 *
 * This is the base class of Skyline's writers. The input is a two-dimensional vtkImageData whose
 * row 0 is the southern edge. The writer writes to a temporary file beside FileName and renames it
 * on success, so that no partial file ever has that name. On failure and on abort, the temporary
 * file is removed. A file from which the input was read is never replaced; the reader lists these
 * files in the field data SourceFiles.
 *
 * Write() returns 1 on success and 0 otherwise. A failure is reported by an ErrorEvent with one
 * line that names the file, the value and the remedy, and by an error code (GetErrorCode). After an
 * abort the code is vtkErrorCode::UserError and no error is reported. Update() also writes the
 * file, if the input or the writer has changed.
 */
#ifndef vtkHeightFieldFileWriter_h
#define vtkHeightFieldFileWriter_h

#include "SkylineIOModule.h"        // for the export macro
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkWriter.h"

#include <string> // for messages

namespace skyline
{
class AtomicFile;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;

class SKYLINEIO_EXPORT vtkHeightFieldFileWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkHeightFieldFileWriter, vtkWriter);
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
  int Write() override;

protected:
  vtkHeightFieldFileWriter();
  ~vtkHeightFieldFileWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void WriteData() override;

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
  vtkHeightFieldFileWriter(const vtkHeightFieldFileWriter&) = delete;
  void operator=(const vtkHeightFieldFileWriter&) = delete;

  void Check(vtkImageData* image) const;

  char* FileName = nullptr;
  bool Written = false;
};
VTK_ABI_NAMESPACE_END

#endif
