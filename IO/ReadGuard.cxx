// SPDX-License-Identifier: BSD-3-Clause
#include "ReadGuard.h"

#include "IoFailure.h"

#include "vtkErrorCode.h"
#include "vtkObject.h"

#include <exception>
#include <new>

namespace skyline
{

unsigned long GuardRead(vtkObject* reader, const char* fileName, const char* lessMemory,
  const std::function<void(const std::string&)>& work)
{
  const std::string file = fileName ? fileName : "";
  try
  {
    if (file.empty())
    {
      throw IoFailure(vtkErrorCode::NoFileNameError, "no file to read; call SetFileName first");
    }
    work(file);
    return vtkErrorCode::NoError;
  }
  catch (const IoAborted&)
  {
    return vtkErrorCode::UserError;
  }
  catch (const IoFailure& failure)
  {
    vtkErrorWithObjectMacro(reader, << failure.what());
    return failure.GetCode();
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorWithObjectMacro(
      reader, << "cannot read '" << file << "': not enough memory; " << lessMemory);
  }
  catch (const std::exception& failure)
  {
    vtkErrorWithObjectMacro(
      reader, << "cannot use '" << file << "': " << FirstLine(failure.what()));
  }
  return vtkErrorCode::UnknownError;
}

} // namespace skyline
