// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldIrradiance
 * @brief   computes the light that falls on each post
 *
 * Adds the float array `Irradiance` with the components R, G and B: the integral of L V max(0, n.d)
 * over all directions d, for the sum of all lights. L is the radiance of the lights, V the
 * visibility, and n the normal at the post, or the vertical with Horizontal. The radiance of a
 * white Lambertian surface is Irradiance / pi. Environments, suns and key lights count only above
 * the horizontal plane; lamps count wherever they are.
 *
 * The cost depends on the lights. All environments and large key lights share one pass over
 * NumberOfAzimuths azimuths, plus the azimuths that are added for bright spots. Each sun or small
 * key light takes a pass over its own swath, and each lamp a pass over the posts that face it. The
 * counters below report the passes of the last execution.
 *
 * With LightMethod HARMONICS, all lights but lamps are multiplied with the transfer of each post
 * (bands^2 floats). The transfer is kept, so that changed lights need no new horizons; but a sun is
 * blurred. With TABLE, changed lights need new horizons unless KeepHorizons is on, which costs one
 * float per post and azimuth.
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

  /// The methods that integrate distant light over the sky that a post sees.
  enum LightMethodType
  {
    TABLE = 0,    ///< exact integrals of the light of each swath above the horizon
    HARMONICS = 1 ///< spherical harmonics with HarmonicBands bands: a fast preview
  };
  /// What is assumed between two searched azimuths.
  enum QuadratureType
  {
    CONSTANT = 0, ///< each horizon stands for its whole swath (Timonen & Westerholm 2010)
    BLEND = 1,    ///< light between two azimuths counts for both horizons, weighted by nearness
    LINEAR = 2    ///< horizons are linear between azimuths; takes one more float per post
  };

  ///@{
  /// Add, remove and get lights. At least one light must be switched on, otherwise the update is an
  /// error. The filter keeps a reference to each light and runs again after a light was modified.
  /// Null is ignored.
  void AddLight(vtkSkylineLight* light);
  void RemoveLight(vtkSkylineLight* light);
  void RemoveAllLights();
  int GetNumberOfLights();
  vtkSkylineLight* GetLight(int index); ///< null if there is no such light
  ///@}

  ///@{
  /// Set/Get how distant lights are integrated. The default is TABLE.
  vtkSetClampMacro(LightMethod, int, TABLE, HARMONICS);
  vtkGetMacro(LightMethod, int);
  void SetLightMethodToTable() { this->SetLightMethod(TABLE); }
  void SetLightMethodToHarmonics() { this->SetLightMethod(HARMONICS); }
  ///@}

  ///@{
  /// Set/Get the number of evenly spaced azimuths. The default is 128, the range 1 to 3600. Other
  /// values are an error of the update.
  vtkSetMacro(NumberOfAzimuths, int);
  vtkGetMacro(NumberOfAzimuths, int);
  ///@}

  ///@{
  /// Search further azimuths where an environment is bright (TABLE only). The default is on. If
  /// off, a small sun in a light map casts its shadow from the middle of its swath.
  vtkSetMacro(Refine, bool);
  vtkGetMacro(Refine, bool);
  vtkBooleanMacro(Refine, bool);
  ///@}

  ///@{
  /// Set/Get what is assumed between two azimuths (TABLE only). The default is CONSTANT.
  vtkSetClampMacro(Quadrature, int, CONSTANT, LINEAR);
  vtkGetMacro(Quadrature, int);
  void SetQuadratureToConstant() { this->SetQuadrature(CONSTANT); }
  void SetQuadratureToBlend() { this->SetQuadrature(BLEND); }
  void SetQuadratureToLinear() { this->SetQuadrature(LINEAR); }
  ///@}

  ///@{
  /// Set/Get the number of bands of HARMONICS. The default is 4, the range 2 to 8. Other values are
  /// an error of the update.
  vtkSetMacro(HarmonicBands, int);
  vtkGetMacro(HarmonicBands, int);
  ///@}

  ///@{
  /// Compute the light on level receivers instead of on the tilted surface at each post. The
  /// default is off.
  vtkSetMacro(Horizontal, bool);
  vtkGetMacro(Horizontal, bool);
  vtkBooleanMacro(Horizontal, bool);
  ///@}

  ///@{
  /// Keep all horizons that were searched (TABLE only), so that changed lights search only azimuths
  /// that no light has needed before. The default is off.
  vtkSetMacro(KeepHorizons, bool);
  vtkGetMacro(KeepHorizons, bool);
  vtkBooleanMacro(KeepHorizons, bool);
  ///@}

  ///@{
  /// Get the number of azimuths that the last execution searched, and its passes over the posts for
  /// each type of light.
  vtkGetMacro(SearchedAzimuths, int);
  vtkGetMacro(EnvironmentPasses, int);
  vtkGetMacro(SunPasses, int);
  vtkGetMacro(LampPasses, int);
  ///@}

  /// Get the time of the last change of this filter or of one of its lights.
  vtkMTimeType GetMTime() override;

protected:
  vtkHeightFieldIrradiance();
  ~vtkHeightFieldIrradiance() override;

  bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) override;

  /// Adds the light of `light`, given as harmonics, to all posts. It uses their transfer, which is
  /// kept as long as `key` is the same. Returns false if aborted.
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
