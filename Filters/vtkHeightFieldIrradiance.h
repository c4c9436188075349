// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldIrradiance
 * @brief   the light that falls on every post
 *
 * Adds `Irradiance`: RGB floats, the integral of L V max(0, n.d) over all directions d, for the sum
 * of the lights added; n is the post's normal, or with Horizontal the vertical. A white Lambertian
 * surface sends out Irradiance / pi. Environments, suns and key lights count above the horizontal
 * plane only, lamps wherever they are.
 *
 * What each light takes: all environments and large key lights one pass over NumberOfAzimuths azimuths
 * and those that their bright spots ask for; each sun or small key light a pass over its own swath;
 * each lamp a pass over the posts that face it. No light, no pass; the counts below tell.
 *
 * With LightMethod HARMONICS all lights but lamps go through the transfer of each post (bands^2
 * floats), which is kept: changed lights take no horizons. A sun is a blur there. With TABLE changed
 * lights take new horizons unless KeepHorizons is on, which costs a float a post and azimuth.
 */
#ifndef vtkHeightFieldIrradiance_h
#define vtkHeightFieldIrradiance_h

#include "vtkHeightFieldAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <memory>
#include <vector>

namespace skyline
{
class HarmonicLight;
struct LitPosts;
} // namespace skyline

VTK_ABI_NAMESPACE_BEGIN
class vtkSkylineLight;

class SKYLINEFILTERS_EXPORT vtkHeightFieldIrradiance : public vtkHeightFieldAlgorithm
{
public:
  static vtkHeightFieldIrradiance* New();
  vtkTypeMacro(vtkHeightFieldIrradiance, vtkHeightFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The ways to integrate distant light over the sky that a post sees.
  enum LightMethodType
  {
    TABLE = 0,    ///< exact integrals of each swath's light above the horizon
    HARMONICS = 1 ///< spherical harmonics of HarmonicBands bands: a fast preview
  };
  /// What is assumed about the horizon between two searched azimuths.
  enum QuadratureType
  {
    CONSTANT = 0, ///< each horizon stands for its swath (Timonen & Westerholm 2010)
    BLEND = 1,    ///< light between two azimuths is weighted between theirs
    LINEAR = 2    ///< horizons are linear between azimuths; a float a post more
  };

  ///@{
  /// The lights. At least one must shine. A light is held, not copied: its changes are heard.
  void AddLight(vtkSkylineLight* light);
  void RemoveLight(vtkSkylineLight* light);
  void RemoveAllLights();
  int GetNumberOfLights();
  vtkSkylineLight* GetLight(int index); ///< null beyond the last
  ///@}

  ///@{
  /// How distant lights are integrated; default TABLE.
  vtkSetClampMacro(LightMethod, int, TABLE, HARMONICS);
  vtkGetMacro(LightMethod, int);
  void SetLightMethodToTable() { this->SetLightMethod(TABLE); }
  void SetLightMethodToHarmonics() { this->SetLightMethod(HARMONICS); }
  ///@}

  ///@{
  /// Evenly spread azimuths; default 128, 1 to 3600.
  vtkSetMacro(NumberOfAzimuths, int);
  vtkGetMacro(NumberOfAzimuths, int);
  ///@}

  ///@{
  /// Search further azimuths where an environment is bright (TABLE); default on. Off, a small sun in a
  /// light map casts the shadow of its swath's middle.
  vtkSetMacro(Refine, bool);
  vtkGetMacro(Refine, bool);
  vtkBooleanMacro(Refine, bool);
  ///@}

  ///@{
  /// What lies between azimuths (TABLE); default CONSTANT.
  vtkSetClampMacro(Quadrature, int, CONSTANT, LINEAR);
  vtkGetMacro(Quadrature, int);
  void SetQuadratureToConstant() { this->SetQuadrature(CONSTANT); }
  void SetQuadratureToBlend() { this->SetQuadrature(BLEND); }
  void SetQuadratureToLinear() { this->SetQuadrature(LINEAR); }
  ///@}

  ///@{
  /// Bands of HARMONICS, 2 to 8; default 4.
  vtkSetMacro(HarmonicBands, int);
  vtkGetMacro(HarmonicBands, int);
  ///@}

  ///@{
  /// Take level receivers in place of the posts' own planes; default off.
  vtkSetMacro(Horizontal, bool);
  vtkGetMacro(Horizontal, bool);
  vtkBooleanMacro(Horizontal, bool);
  ///@}

  ///@{
  /// Keep all horizons searched (TABLE), so that changed lights search only azimuths that no light
  /// needed before; default off.
  vtkSetMacro(KeepHorizons, bool);
  vtkGetMacro(KeepHorizons, bool);
  vtkBooleanMacro(KeepHorizons, bool);
  ///@}

  ///@{
  /// Of the last execution: azimuths searched, and passes over the posts by kind of light.
  vtkGetMacro(SearchedAzimuths, int);
  vtkGetMacro(EnvironmentPasses, int);
  vtkGetMacro(SunPasses, int);
  vtkGetMacro(LampPasses, int);
  ///@}

  /// The time of the last change of this filter or of one of its lights.
  vtkMTimeType GetMTime() override;

protected:
  vtkHeightFieldIrradiance();
  ~vtkHeightFieldIrradiance() override;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

  /// Adds what a light in harmonics gives to all posts, from their transfer, which is kept as long as
  /// `key` is the same. False if stopped.
  virtual bool LightByHarmonics(skyline::HorizonDriver& driver, const skyline::HarmonicLight& light,
    const std::vector<double>& key, const skyline::LitPosts& posts);

  int LightMethod = TABLE;
  int NumberOfAzimuths = 128;
  bool Refine = true;
  int Quadrature = CONSTANT;
  int HarmonicBands = 4;
  bool Horizontal = false;
  bool KeepHorizons = false;
  int SearchedAzimuths = 0;
  int EnvironmentPasses = 0;
  int SunPasses = 0;
  int LampPasses = 0;

private:
  vtkHeightFieldIrradiance(const vtkHeightFieldIrradiance&) = delete;
  void operator=(const vtkHeightFieldIrradiance&) = delete;

  struct SortedLights;
  std::vector<double> SurfaceKey(skyline::HorizonDriver& driver, vtkImageData* image);
  std::ptrdiff_t FloatsOfPasses(const SortedLights& lights, bool uniform) const;
  bool AddHarmonics(skyline::HorizonDriver& driver, const SortedLights& lights,
    const std::vector<double>& surface, const skyline::LitPosts& posts);
  bool AddTables(
    skyline::HorizonDriver& driver, const SortedLights& lights, const skyline::LitPosts& posts);
  bool AddLamps(skyline::HorizonDriver& driver, const SortedLights& lights, vtkImageData* image,
    const skyline::LitPosts& posts);

  struct Internal;
  std::unique_ptr<Internal> Internals;
};
VTK_ABI_NAMESPACE_END

#endif
