// SPDX-License-Identifier: BSD-3-Clause
// A terrain and its light, computed layer by layer. A layer that has not changed is not recomputed.
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

/// Seconds for each pass.
using PassTimes = std::vector<std::pair<std::string, double>>;

/// The light on a terrain.
struct TerrainLight
{
  bool SunOn = true;
  SunLight Sun;
  SunDescription SunAsked; ///< what Sun was computed from
  SkyDescription Sky;
  vtkSmartPointer<vtkSkylineEnvironmentLight> Environment; ///< for Formula, Perez and Map
  Rgb MeasuredSun{ { 1, 1, 1 } };                          ///< irradiance with a measured sky
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
  /// `heights` has the point array Elevation.
  LitTerrain(vtkImageData* heights, const HorizonOptions& options);
  ~LitTerrain();
  LitTerrain(const LitTerrain&) = delete;
  LitTerrain& operator=(const LitTerrain&) = delete;

  /// Called between parts of exact work; true stops the work.
  std::function<bool()> Stop;

  /// Computes what differs from the last call. If not exact, light maps are computed with spherical
  /// harmonics, the sun from bounds of its horizon, as if it had one direction for all posts, and
  /// lamps with LampPreview. Returns false if stopped; the output is then that of the last call.
  /// Throws Failure.
  bool Light(const TerrainLight& light, bool exact);

  /// The heights with Radiance, as vtkHeightFieldShading makes it; null before the first call of
  /// Light.
  vtkImageData* GetOutput() const;
  vtkImageData* GetHeights() const;                     ///< not exaggerated
  double GetExposure() const { return this->Exposure; } ///< automatic, stops; full for light maps
  /// The mean radiance over open level ground; for a sky formula (CIE, not zonal) that of its
  /// zenith.
  const Rgb& GetSkyRadiance() const { return this->SkyRadiance; }
  /// Irradiance / pi of open level ground by sun and sky formula, without lamps and light maps.
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
  double Exaggeration = 0.0;            ///< of Scaled; 0: not computed yet

  vtkSmartPointer<vtkFloatArray> Sky; ///< of uniform and zonal skies
  std::string SkyKey;
  vtkSmartPointer<vtkFloatArray> Map; ///< irradiance of light maps and sky formulas
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
