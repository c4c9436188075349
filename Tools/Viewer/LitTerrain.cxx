// SPDX-License-Identifier: BSD-3-Clause
#include "LitTerrain.h"

#include "Exposure.h"
#include "HeightRay.h"
#include "PicturePasses.h"
#include "RunPass.h"
#include "Shared/Constants.h"
#include "Twilight.h"

#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "vtkHeightFieldAlgorithm.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldShading.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineLampLight.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

namespace
{

/// Greatest size in bytes of the horizons that are kept to light with another map without a new
/// search.
constexpr double KeptHorizons = 1.0e9;

/// Least elevation of the sun of a sky: sky formulas end at the horizon.
constexpr double LowestSkySun = 0.0;

// Calls a function at progress events.
class Asking : public vtkCommand
{
public:
  static Asking* New() { return new Asking; }
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    if (this->Stop && *this->Stop && (*this->Stop)())
    {
      vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
    }
  }
  const std::function<bool()>* Stop = nullptr;
};

// A text that differs if one of the parts differs.
template <typename... Parts>
std::string Key(const Parts&... parts)
{
  std::ostringstream text;
  text.precision(17);
  ((text << parts << '|'), ...);
  return text.str();
}

vtkSmartPointer<vtkFloatArray> TakeArray(vtkAlgorithm* filter, const char* name)
{
  auto* image = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  return vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(name));
}

// Radiance of a sky that gives as much light as the posts receive on average.
skyline::Rgb MeanRadiance(vtkFloatArray* irradiance)
{
  std::array<double, 3> sum{};
  vtkIdType lit = 0;
  const float* light = irradiance->GetPointer(0);
  for (vtkIdType post = 0; post < irradiance->GetNumberOfTuples(); ++post, light += 3)
  {
    if (std::isfinite(light[0] + light[1] + light[2]))
    {
      ++lit;
      for (std::size_t c = 0; c < 3; ++c)
      {
        sum[c] += light[c];
      }
    }
  }
  skyline::Rgb mean{};
  for (std::size_t c = 0; c < 3 && lit > 0; ++c)
  {
    mean[c] = static_cast<float>(sum[c] / (skyline::Pi * static_cast<double>(lit)));
  }
  return mean;
}

void Add(vtkFloatArray* light, vtkFloatArray* sum)
{
  const vtkIdType count = sum->GetNumberOfValues();
  const float* from = light->GetPointer(0);
  float* to = sum->GetPointer(0);
  for (vtkIdType k = 0; k < count; ++k)
  {
    to[k] += from[k];
  }
}

} // namespace

namespace skyline
{

LitTerrain::LitTerrain(vtkImageData* heights, const HorizonOptions& options)
  : Options(options)
  , Heights(heights)
  , Shading(vtkSmartPointer<vtkHeightFieldShading>::New())
{
  this->Shading->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

LitTerrain::~LitTerrain() = default;

vtkImageData* LitTerrain::GetOutput() const
{
  return this->Output;
}

vtkImageData* LitTerrain::GetHeights() const
{
  return this->Heights;
}

bool LitTerrain::Run(vtkAlgorithm* filter, const std::string& title, bool stoppable)
{
  vtkNew<Asking> asking;
  asking->Stop = &this->Stop;
  filter->SetAbortExecute(0);
  const unsigned long tag = stoppable ? filter->AddObserver(vtkCommand::ProgressEvent, asking) : 0;
  const auto start = std::chrono::steady_clock::now();
  CommonOptions silent;
  silent.Quiet = true;
  try
  {
    RunPass(filter, title, silent);
  }
  catch (...)
  {
    filter->RemoveObserver(tag);
    filter->Modified(); // a failed update is no result
    throw;
  }
  filter->RemoveObserver(tag);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  this->Times.emplace_back(title, time.count());
  if (filter->GetAbortExecute())
  {
    filter->SetAbortExecute(0);
    filter->Modified(); // neither is a stopped one
    return false;
  }
  return true;
}

void LitTerrain::Exaggerate(const TerrainLight& light)
{
  if (this->Exaggeration == light.Exaggeration)
  {
    return;
  }
  this->Scaled = skyline::Exaggerate(this->Heights, light.Exaggeration,
    [this](vtkAlgorithm* filter, const std::string& title) { this->Run(filter, title, false); });
  this->Exaggeration = light.Exaggeration;
  this->SkyKey.clear();
  this->MapKey.clear();
  this->SunKey.clear();
  this->Lamps.clear();
  this->Preview.reset();
  this->FastMap = nullptr;
  this->ExactMap = nullptr;
  this->FastSun = nullptr;
  this->ExactSun = nullptr;
}

bool LitTerrain::LightSky(const TerrainLight& light, bool exact)
{
  const std::string key = light.Sky.Text;
  if (!HasSkyPass(light.Sky.Kind) || key == this->SkyKey)
  {
    return true;
  }
  const SkyPass sky = MakeSkyPass(light.Sky, this->Scaled, this->Options);
  const bool done = this->Run(sky.Filter, "sky", exact);
  this->Sky = done ? TakeArray(sky.Filter, sky.Array) : this->Sky;
  this->SkyKey = done ? key : this->SkyKey;
  return done;
}

bool LitTerrain::LightMap(const TerrainLight& light, bool exact)
{
  if (!HasEnvironment(light.Sky.Kind))
  {
    return true;
  }
  vtkSkylineEnvironmentLight* map = light.Environment;
  const bool byFormula = map->GetSource() != vtkSkylineEnvironmentLight::IMAGE;
  const double elevation = std::max(light.Sun.ApparentElevation, LowestSkySun);
  const double given = byFormula ? light.Sun.ApparentElevation : 0.0; // including twilight
  const std::string key =
    Key(light.Sky.Text, light.Rotation, exact, byFormula ? light.Sun.SkyAzimuth : 0.0, given);
  if (key == this->MapKey)
  {
    return true;
  }
  map->SetRotation(light.Rotation);
  map->SetSunAzimuth(light.Sun.SkyAzimuth);
  map->SetSunElevation(elevation);
  if (light.Sky.Kind == SkyKind::Formula)
  {
    const Rgb sky = DaylightAndNight(light.Sun.ApparentElevation, light.Air).SkyRadiance;
    map->SetRadiance(sky[0], sky[1], sky[2]);
  }
  auto& filter = exact ? this->ExactMap : this->FastMap;
  if (!filter)
  {
    filter = MakeIrradiancePass(this->Scaled, this->Options);
    if (exact)
    {
      const double bytes = 4.0 * static_cast<double>(this->Scaled->GetNumberOfPoints());
      filter->SetKeepHorizons(bytes * this->Options.Azimuths <= KeptHorizons);
    }
    else
    {
      filter->SetLightMethodToHarmonics();
    }
  }
  if (filter->GetLight(0) != map)
  {
    filter->RemoveAllLights();
    filter->AddLight(map);
  }
  if (!this->Run(filter, "light map", exact))
  {
    return false;
  }
  this->Map = TakeArray(filter, "Irradiance");
  this->MapKey = key;
  return true;
}

bool LitTerrain::LightSun(const TerrainLight& light, bool exact)
{
  const bool byTime = exact && light.Sun.FromTime;
  const std::string key = Key(exact, light.Sun.GridAzimuth, light.Sun.ApparentElevation,
    light.Sun.Radius, byTime ? light.SunAsked.Time : "");
  if (key == this->SunKey)
  {
    return true;
  }
  auto& filter = exact ? this->ExactSun : this->FastSun;
  if (!filter)
  {
    filter = MakeShadowPass(this->Scaled, this->Options);
    if (!exact)
    {
      filter->SetMethodToFast();
    }
  }
  ApplySun(light.SunAsked, light.Sun, filter->GetSun());
  filter->SetUseTime(byTime);
  if (!this->Run(filter, "sun", exact))
  {
    return false;
  }
  this->Sun = TakeArray(filter, "SunVisibility");
  this->SunKey = key;
  return true;
}

bool LitTerrain::LightLamps(const TerrainLight& light, bool exact)
{
  std::vector<LampLayer> layers;
  for (const ViewerLamp& lamp : light.Lamps)
  {
    const auto known = std::find_if(this->Lamps.begin(), this->Lamps.end(),
      [&](const LampLayer& layer) { return layer.Lamp == lamp && layer.Exact >= exact; });
    if (known != this->Lamps.end())
    {
      layers.push_back(*known);
      continue;
    }
    const double ground = GroundOrZero(this->Heights, light.Exaggeration, lamp.X, lamp.Y);
    if (!exact)
    {
      const auto start = std::chrono::steady_clock::now();
      if (!this->Preview)
      {
        this->Preview = std::make_unique<LampPreview>(this->Scaled);
      }
      layers.push_back({ lamp, this->Preview->Light(lamp, ground + lamp.Height), exact });
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
      this->Times.emplace_back("lamp", time.count());
      continue;
    }
    vtkNew<vtkSkylineLampLight> source;
    source->SetPosition(lamp.X, lamp.Y, ground + lamp.Height);
    source->SetRadius(lamp.Radius);
    source->SetRadiance(lamp.Radiance[0], lamp.Radiance[1], lamp.Radiance[2]);
    const auto filter = MakeIrradiancePass(this->Scaled, this->Options);
    filter->AddLight(source);
    if (!this->Run(filter, "lamp", exact))
    {
      return false;
    }
    layers.push_back({ lamp, TakeArray(filter, "Irradiance"), exact });
  }
  this->Lamps = layers;
  return true;
}

Daylight LitTerrain::ChooseDaylight(const TerrainLight& light) const
{
  Daylight day = DaylightAndNight(light.Sun.ApparentElevation, light.Air);
  if (light.Sky.Measured())
  {
    day.SunIrradiance = light.MeasuredSun;
  }
  else
  {
    ReplaceSun(light.SunAsked.Irradiance, day);
  }
  if (!light.SunOn)
  {
    day.SunIrradiance = Rgb{};
  }
  return day;
}

void LitTerrain::MeterSky(const TerrainLight& light, const Daylight& day)
{
  const SkyKind kind = light.Sky.Kind;
  const auto rise =
    static_cast<float>(std::sin(std::max(light.Sun.ApparentElevation, 0.0) * RadiansPerDegree));
  for (std::size_t c = 0; c < 3; ++c)
  {
    const float sky = kind == SkyKind::None ? 0.0f : day.SkyRadiance[c];
    this->GroundLight[c] = sky + rise * day.SunIrradiance[c] / static_cast<float>(Pi);
  }
  this->SkyRadiance = kind == SkyKind::None ? Rgb{}
    : light.Sky.Measured()                  ? MeanRadiance(this->Map)
                                            : day.SkyRadiance;
}

vtkSmartPointer<vtkFloatArray> LitTerrain::SumFurtherLight(bool map) const
{
  auto further = vtkSmartPointer<vtkFloatArray>::New();
  further->SetName("Further");
  further->SetNumberOfComponents(3);
  further->SetNumberOfTuples(this->Scaled->GetNumberOfPoints());
  further->FillValue(0.0f);
  if (map)
  {
    Add(this->Map, further);
  }
  for (const LampLayer& layer : this->Lamps)
  {
    Add(layer.Light, further);
  }
  return further;
}

void LitTerrain::Shade(const TerrainLight& light, bool exact)
{
  const SkyKind kind = light.Sky.Kind;
  Daylight day = this->ChooseDaylight(light);
  this->MeterSky(light, day);
  if (!HasSkyPass(kind))
  {
    day.SkyRadiance = Rgb{};
  }

  vtkNew<vtkImageData> posts;
  posts->ShallowCopy(this->Scaled);
  vtkPointData* arrays = posts->GetPointData();
  const bool map = HasEnvironment(kind);
  if (this->Sky && !map)
  {
    this->Sky->SetName("Sky");
    arrays->AddArray(this->Sky);
  }
  if (this->Sun && SunShines(day))
  {
    arrays->AddArray(this->Sun);
  }
  const bool further = map || !this->Lamps.empty();
  if (further)
  {
    arrays->AddArray(this->SumFurtherLight(map));
  }
  this->Shading->SetIrradianceArrayName(further ? "Further" : "");
  this->Shading->SetInputData(posts);
  this->Shading->SetSkyArrayName("Sky");
  ApplySun(light.SunAsked, light.Sun, this->Shading->GetSun());
  this->Shading->SetUseTime(exact && light.Sun.FromTime);
  SetDaylight(day, this->Shading);
  this->Shading->SetColorMap(light.Colors);
  this->Run(this->Shading, "shading", false);
  const double stops = this->Shading->GetUsedExposure();
  this->Exposure = light.Sky.Measured() ? stops : AdaptedStops(stops);
  this->Output = vtkSmartPointer<vtkImageData>::New();
  this->Output->ShallowCopy(this->Shading->GetOutput());
}

bool LitTerrain::Light(const TerrainLight& light, bool exact)
{
  this->Times.clear();
  this->Exaggerate(light);
  const bool shines = light.SunOn &&
    (light.Sky.Measured() || SunShines(DaylightAndNight(light.Sun.ApparentElevation, light.Air)));
  if (!this->LightSky(light, exact) || !this->LightMap(light, exact) ||
    (shines && !this->LightSun(light, exact)) || !this->LightLamps(light, exact))
  {
    return false;
  }
  this->Shade(light, exact);
  return true;
}

} // namespace skyline
