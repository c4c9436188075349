// SPDX-License-Identifier: BSD-3-Clause
// A terrain and its light, computed layer by layer: what has not changed is not computed again.
#ifndef skyline_LitTerrain_h
#define skyline_LitTerrain_h

#include "Color/Daylight.h"
#include "LampPreview.h"
#include "Options.h"
#include "SunLight.h"
#include "ViewerState.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkFloatArray;
class vtkHeightFieldIrradiance;
class vtkHeightFieldShading;
class vtkHeightFieldSunShadow;
class vtkImageData;
class vtkSkylineEnvironmentLight;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// Seconds by pass.
using PassTimes = std::vector<std::pair<std::string, double>>;

/// The light on a terrain.
struct TerrainLight
{
  bool SunOn = true;
  SunLight Sun;
  SunDescription SunAsked; ///< what Sun was found from
  SkyDescription Sky;
  vtkSmartPointer<vtkSkylineEnvironmentLight> Environment; ///< of Formula, Perez and Map
  Rgb MeasuredSun{ { 1, 1, 1 } };                          ///< irradiance beside a measured sky
  bool Air = true;
  double Rotation = 0.0; ///< degrees
  std::vector<ViewerLamp> Lamps;
  double Exaggeration = 1.0;
  std::string Colors;
};

/// One terrain at one resolution.
class LitTerrain
{
public:
  /// `heights`: with the point array Elevation.
  LitTerrain(vtkImageData* heights, const HorizonOptions& options);
  ~LitTerrain();
  LitTerrain(const LitTerrain&) = delete;
  LitTerrain& operator=(const LitTerrain&) = delete;

  /// Asked between pieces of exact work; true stops it.
  std::function<bool()> Stop;

  /// Computes what differs from the last call. Not exact: light maps by spherical harmonics, the sun
  /// by bounds of its horizon, as if it stood in one direction for all posts, lamps by LampPreview. False if stopped; the
  /// output then is the last one. Throws Failure.
  bool Light(const TerrainLight& light, bool exact);

  /// The heights with Radiance, as vtkHeightFieldShading makes it; null before the first Light.
  vtkImageData* GetOutput() const;
  vtkImageData* GetHeights() const;                     ///< not exaggerated
  double GetExposure() const { return this->Exposure; } ///< stops, automatic; a light map's in full
  /// Mean of the sky over open level ground; of a formula's sky (CIE, not zonal) that of its zenith.
  const Rgb& GetSkyRadiance() const { return this->SkyRadiance; }
  /// Irradiance over pi of open level ground by sun and formula; without lamps and light maps.
  const Rgb& GetGroundLight() const { return this->GroundLight; }
  const PassTimes& GetTimes() const { return this->Times; } ///< of the last Light

private:
  struct LampLayer
  {
    ViewerLamp Lamp;
    vtkSmartPointer<vtkFloatArray> Light;
    bool Exact;
  };

  void Exaggerate(const TerrainLight& light);
  bool LightSky(const TerrainLight& light, bool exact);
  bool LightMap(const TerrainLight& light, bool exact);
  bool LightSun(const TerrainLight& light, bool exact);
  bool LightLamps(const TerrainLight& light, bool exact);
  Daylight ChooseDaylight(const TerrainLight& light) const;
  void MeterSky(const TerrainLight& light, const Daylight& day);
  vtkSmartPointer<vtkFloatArray> SumFurtherLight(bool map) const;
  void Shade(const TerrainLight& light, bool exact);
  bool Run(vtkAlgorithm* filter, const std::string& title, bool stoppable);

  HorizonOptions Options;
  vtkSmartPointer<vtkImageData> Heights;
  vtkSmartPointer<vtkImageData> Scaled; ///< exaggerated
  double Exaggeration = 0.0;            ///< of Scaled; 0: not made yet

  vtkSmartPointer<vtkFloatArray> Sky; ///< of uniform and zonal skies
  std::string SkyKey;
  vtkSmartPointer<vtkFloatArray> Map; ///< irradiance of light maps and formulas
  std::string MapKey;
  vtkSmartPointer<vtkHeightFieldIrradiance> FastMap, ExactMap;
  vtkSmartPointer<vtkFloatArray> Sun; ///< SunVisibility
  std::string SunKey;
  vtkSmartPointer<vtkHeightFieldSunShadow> FastSun, ExactSun;
  std::vector<LampLayer> Lamps;
  std::unique_ptr<LampPreview> Preview;

  vtkSmartPointer<vtkHeightFieldShading> Shading;
  vtkSmartPointer<vtkImageData> Output;
  double Exposure = 0.0;
  Rgb SkyRadiance{ {} };
  Rgb GroundLight{ {} };
  PassTimes Times;
};

} // namespace skyline

#endif
