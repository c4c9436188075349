// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldSunShadow
 * @brief   how much of the sun every post sees
 *
 * Adds `SunVisibility`: the lit fraction of the sun's disc above the horizon curve across its swath,
 * 0 (full shadow) to 1. The sun is one direction for all posts, or, with UseTime, the sun of that
 * time at the place of each post (needs a georeference). Only the swath of the sun is searched.
 *
 * In an eclipse at that time the visibility is multiplied by the share of the sun's light that the Moon
 * leaves at the post (skyline::EclipseField). The product is exact where the terrain leaves all of the
 * disc or none, and in totality; where it cuts the disc of an eclipsed sun it can be off by 0.25, for
 * the horizon may cut the bright part or the dark one.
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
  /// Let the disc darken towards its limb (Eddington, u = 0.6); default off.
  void SetLimbDarkening(bool on) { this->Sun->SetLimbDarkening(on); }
  bool GetLimbDarkening() { return this->Sun->GetLimbDarkening(); }
  void LimbDarkeningOn() { this->SetLimbDarkening(true); }
  void LimbDarkeningOff() { this->SetLimbDarkening(false); }
  ///@}

  /// Azimuths searched by the last execution.
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
