// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldSunShadow
 * @brief   computes how much of the sun each post sees
 *
 * Adds the float array `SunVisibility`: the part of the sun's disc that lies above the horizon, 0
 * (full shadow) to 1. The horizon is searched across the swath of the sun only. The sun has one
 * direction for all posts; with UseTime its direction is that of the given time at the place of
 * each post, which needs a georeference.
 *
 * During an eclipse at that time, the visibility is multiplied by the share of the sun's light that
 * the Moon leaves at the post (skyline::EclipseField). The product is exact where the terrain hides
 * all of the disc or none of it, and in totality. Where the terrain cuts the disc of an eclipsed
 * sun, the product can be off by up to 0.25, since the horizon may hide the bright part or the dark
 * part.
 */
#ifndef vtkHeightFieldSunShadow_h
#define vtkHeightFieldSunShadow_h

#include "vtkHeightFieldSunAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class SKYLINEFILTERS_EXPORT vtkHeightFieldSunShadow : public vtkHeightFieldSunAlgorithm
{
public:
  static vtkHeightFieldSunShadow* New();
  vtkTypeMacro(vtkHeightFieldSunShadow, vtkHeightFieldSunAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Set/Get whether the disc darkens towards its limb (Eddington, u = 0.6). The default is off.
  void SetLimbDarkening(bool on) { this->Sun->SetLimbDarkening(on); }
  bool GetLimbDarkening() { return this->Sun->GetLimbDarkening(); }
  void LimbDarkeningOn() { this->SetLimbDarkening(true); }
  void LimbDarkeningOff() { this->SetLimbDarkening(false); }
  ///@}

  /// Get the number of azimuths that the last execution searched.
  vtkGetMacro(SearchedAzimuths, int);

protected:
  vtkHeightFieldSunShadow() = default;
  ~vtkHeightFieldSunShadow() override = default;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

  int SearchedAzimuths = 0;

private:
  vtkHeightFieldSunShadow(const vtkHeightFieldSunShadow&) = delete;
  void operator=(const vtkHeightFieldSunShadow&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
