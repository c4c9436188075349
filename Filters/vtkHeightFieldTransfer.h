// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldTransfer
 * @brief   computes the transfer of each post as spherical harmonics
 *
 * Adds the float array `TransferSH` with bands^2 components: the spherical harmonics of the
 * visibility times max(0, cosine of the angle of incidence). The order of the coefficients is that
 * of vtkHeightFieldVisibility. The irradiance by a light with the coefficients L is the dot product
 * with L; another light therefore needs no new horizons. This is the transfer vector of Snyder &
 * Nowrouzezahrai 2008, section 5, but the product is integrated here, not multiplied from two
 * truncated series.
 */
#ifndef vtkHeightFieldTransfer_h
#define vtkHeightFieldTransfer_h

#include "vtkHeightFieldVisibility.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkHeightFieldTransfer : public vtkHeightFieldVisibility
{
public:
  static vtkHeightFieldTransfer* New();
  vtkTypeMacro(vtkHeightFieldTransfer, vtkHeightFieldVisibility);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkHeightFieldTransfer() = default;
  ~vtkHeightFieldTransfer() override = default;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

private:
  vtkHeightFieldTransfer(const vtkHeightFieldTransfer&) = delete;
  void operator=(const vtkHeightFieldTransfer&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
