// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldSink
 * @brief   a pipeline's end that writes a file, complete or not at all
 *
 * What the writers have in common: they take a two-dimensional vtkImageData whose row 0 is the
 * south edge, write to a temporary beside FileName and rename it on success, so that no partial
 * file ever bears the name; on failure and on abort the temporary is removed. A file that the input
 * was read from, as the reader's field data tell, is never replaced. A failure is one line
 * through ErrorEvent, which names the file, the value and the cure, and a code (GetErrorCode).
 * After an abort the code is vtkErrorCode::UserError and nothing is said.
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
   * The file to write. One that exists is replaced.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Updates the input and writes it. Returns 1 when the file is there, else 0.
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

  /// The image's point array of that name, or its scalars for an empty name. Throws IoFailure with
  /// the names there are.
  vtkDataArray* FindArray(vtkImageData* image, const std::string& name) const;

  /// Reports the part done; throws IoAborted if someone asked to stop.
  void Report(double part);

  /// Throws IoFailure: "cannot write 'FILE': reason".
  [[noreturn]] void Refuse(const std::string& reason) const;

  /// The extension of FileName in small letters, without the dot.
  std::string GetExtension() const;

private:
  vtkHeightFieldSink(const vtkHeightFieldSink&) = delete;
  void operator=(const vtkHeightFieldSink&) = delete;

  void Check(vtkImageData* image) const;

  char* FileName = nullptr;
  bool Written = false;
};

#endif
