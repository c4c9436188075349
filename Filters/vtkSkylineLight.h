// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkylineLight
 * @brief   base class of the lights that light a height field
 *
 * Several filters and mappers can share a light; they update after each change of it. Colours are
 * linear RGB. A light that is switched off costs no time.
 */
#ifndef vtkSkylineLight_h
#define vtkSkylineLight_h

#include "SkylineFiltersModule.h" // for the export macro
#include "vtkObject.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkSkylineLight : public vtkObject
{
public:
  vtkTypeMacro(vtkSkylineLight, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Set/Get whether the light is on. The default is on.
  vtkSetMacro(Switch, bool);
  vtkGetMacro(Switch, bool);
  vtkBooleanMacro(Switch, bool);
  ///@}

protected:
  vtkSkylineLight() = default;
  ~vtkSkylineLight() override = default;

  bool Switch = true;

private:
  vtkSkylineLight(const vtkSkylineLight&) = delete;
  void operator=(const vtkSkylineLight&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
