// SPDX-License-Identifier: BSD-3-Clause
// Images for filters, and the errors that filters report.
#ifndef skyline_FilterTesting_h
#define skyline_FilterTesting_h

#include "Reference/FieldImage.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"

#include <string>

namespace skyline
{
namespace testing
{

/// Collects the error messages of an algorithm and its executive.
class ErrorCatcher : public vtkCommand
{
public:
  static ErrorCatcher* New() { return new ErrorCatcher; }
  void Execute(vtkObject*, unsigned long, void* text) override
  {
    this->Text += static_cast<const char*>(text);
    ++this->Count;
  }
  void Watch(vtkAlgorithm* algorithm) { algorithm->AddObserver(vtkCommand::ErrorEvent, this); }
  std::string Text;
  int Count = 0;
};

} // namespace testing
} // namespace skyline

#endif
