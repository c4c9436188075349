// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldTransfer
 * @brief   how every post turns distant light into irradiance, as spherical harmonics
 *
 * Adds the float array `TransferSH`: the coefficients of visibility times max(0, cosine at the post's
 * normal), bands^2 components, as in vtkHeightFieldVisibility. The irradiance of a light with the
 * coefficients L is the dot product with L: another light needs no horizons (the transfer vector of
 * Snyder & Nowrouzezahrai 2008, section 5; here the product is integrated, not multiplied from two
 * truncated series).
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
