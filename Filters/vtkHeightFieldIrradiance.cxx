// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldIrradiance.h"

#include "Azimuths.h"
#include "HarmonicBands.h"
#include "HarmonicLight.h"
#include "Harmonics/VisibilityAccumulator.h"
#include "HorizonDriver.h"
#include "LampReach.h"
#include "LightPasses.h"
#include "PostArrays.h"
#include "Sky/LightAzimuths.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineKeyLight.h"
#include "vtkSkylineLampLight.h"
#include "vtkSkylineSunLight.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeightFieldIrradiance);

namespace
{

/// Turns the light map to the axes of the ground (HorizonInput::Place): by the direction of its sun
/// if it has one, otherwise by its north.
skyline::TurnedLightMap OnGround(
  vtkSkylineEnvironmentLight* environment, const skyline::HorizonDriver& driver)
{
  skyline::TurnedLightMap map = environment->GetLightMap();
  const int source = environment->GetSource();
  const bool formula =
    source == vtkSkylineEnvironmentLight::CIE || source == vtkSkylineEnvironmentLight::PEREZ;
  const double sun =
    formula ? std::fmod(environment->GetSunAzimuth(), 360.0) * skyline::RadiansPerDegree : 0.0;
  skyline::SkyDisc disc;
  disc.Azimuth = sun + map.Rotation;
  map.Rotation = skyline::InMiddle(disc, driver).Azimuth - sun;
  return map;
}

} // namespace

// The lights that are on, sorted by how they are computed.
struct vtkHeightFieldIrradiance::SortedLights
{
  std::vector<skyline::TurnedLightMap> Maps;
  std::vector<skyline::SkyDisc> Discs; // small key lights
  std::vector<skyline::SkyDisc> LargeDiscs;
  std::vector<vtkSkylineSunLight*> Suns;
  std::vector<vtkSkylineLampLight*> Lamps;
  std::vector<int> LampNumbers; // for messages: from 1, in the order of AddLight
  int AllLamps = 0;

  std::size_t Count() const
  {
    return this->Maps.size() + this->Discs.size() + this->LargeDiscs.size() + this->Suns.size() +
      this->Lamps.size();
  }

  void Add(vtkSkylineLight* light, const skyline::HorizonDriver& driver)
  {
    this->AllLamps += vtkSkylineLampLight::SafeDownCast(light) ? 1 : 0;
    if (!light->GetSwitch())
    {
      return;
    }
    if (auto* environment = vtkSkylineEnvironmentLight::SafeDownCast(light))
    {
      this->Maps.push_back(OnGround(environment, driver));
    }
    else if (auto* sun = vtkSkylineSunLight::SafeDownCast(light))
    {
      skyline::DiscOf(sun); // throws before any work is done
      this->Suns.push_back(sun);
    }
    else if (auto* key = vtkSkylineKeyLight::SafeDownCast(light))
    {
      const skyline::SkyDisc disc = skyline::DiscOf(key);
      (disc.Radius <= skyline::LargestSun ? this->Discs : this->LargeDiscs).push_back(disc);
    }
    else if (auto* lamp = vtkSkylineLampLight::SafeDownCast(light))
    {
      this->Lamps.push_back(lamp);
      this->LampNumbers.push_back(this->AllLamps);
    }
  }
};

struct vtkHeightFieldIrradiance::Internal
{
  std::vector<vtkSmartPointer<vtkSkylineLight>> Lights;
  skyline::HorizonCache Cache;
  std::vector<double> TransferKey; // identifies the surface and settings of Transfer
  std::vector<float> Transfer;
};

vtkHeightFieldIrradiance::vtkHeightFieldIrradiance()
  : Internals(new Internal)
{
}

vtkHeightFieldIrradiance::~vtkHeightFieldIrradiance() = default;

void vtkHeightFieldIrradiance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lights: " << this->Internals->Lights.size() << "\n"
     << indent << "LightMethod: " << this->LightMethod << "\n"
     << indent << "NumberOfAzimuths: " << this->NumberOfAzimuths << "\n"
     << indent << "Refine: " << this->Refine << "\n"
     << indent << "Quadrature: " << this->Quadrature << "\n"
     << indent << "HarmonicBands: " << this->HarmonicBands << "\n"
     << indent << "Horizontal: " << this->Horizontal << "\n"
     << indent << "KeepHorizons: " << this->KeepHorizons << "\n"
     << indent << "SearchedAzimuths: " << this->SearchedAzimuths << "\n"
     << indent << "EnvironmentPasses: " << this->EnvironmentPasses << "\n"
     << indent << "SunPasses: " << this->SunPasses << "\n"
     << indent << "LampPasses: " << this->LampPasses << "\n";
}

void vtkHeightFieldIrradiance::AddLight(vtkSkylineLight* light)
{
  if (light)
  {
    this->Internals->Lights.emplace_back(light);
    this->Modified();
  }
}

void vtkHeightFieldIrradiance::RemoveLight(vtkSkylineLight* light)
{
  auto& lights = this->Internals->Lights;
  const auto place = std::find(lights.begin(), lights.end(), light);
  if (place != lights.end())
  {
    lights.erase(place);
    this->Modified();
  }
}

void vtkHeightFieldIrradiance::RemoveAllLights()
{
  if (!this->Internals->Lights.empty())
  {
    this->Internals->Lights.clear();
    this->Modified();
  }
}

int vtkHeightFieldIrradiance::GetNumberOfLights()
{
  return static_cast<int>(this->Internals->Lights.size());
}

vtkSkylineLight* vtkHeightFieldIrradiance::GetLight(int index)
{
  return index >= 0 && index < this->GetNumberOfLights()
    ? this->Internals->Lights[static_cast<std::size_t>(index)].GetPointer()
    : nullptr;
}

vtkMTimeType vtkHeightFieldIrradiance::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkSkylineLight* light : this->Internals->Lights)
  {
    time = std::max(time, light->GetMTime());
  }
  return time;
}

// The values that the horizons of a height field depend on.
std::vector<double> vtkHeightFieldIrradiance::SurfaceKey(
  skyline::HorizonDriver& driver, vtkImageData* image)
{
  const skyline::Grid& grid = driver.Input().Posts();
  const std::uint64_t heights = driver.Input().Checksum();
  vtkMTimeType time = 0;
  vtkFieldData* place = image->GetFieldData();
  for (int i = 0; i < place->GetNumberOfArrays(); ++i)
  {
    time = std::max(time, place->GetAbstractArray(i)->GetMTime());
  }
  return { static_cast<double>(heights >> 32), static_cast<double>(heights & 0xffffffffu),
    static_cast<double>(time), static_cast<double>(grid.Columns), static_cast<double>(grid.Rows),
    grid.SpacingX, grid.SpacingY, 1.0 * this->Method, 1.0 * this->Surface, this->Flat ? 1.0 : 0.0,
    this->RefractionCoefficient, this->Tolerance, this->LevelStep, this->LevelOffset,
    this->LevelDistance, this->LevelSpline ? 1.0 : 0.0 };
}

// Floats per post besides the height: the result, the gradients, and the pass that takes most.
std::ptrdiff_t vtkHeightFieldIrradiance::FloatsOfPasses(
  const SortedLights& lights, bool uniform) const
{
  std::ptrdiff_t pass = 0; // of the lamps
  if (this->LightMethod == HARMONICS)
  {
    pass = skyline::HarmonicCount(this->HarmonicBands) + skyline::WedgeGroup - 1 + this->Horizontal;
  }
  else if (!lights.Suns.empty())
  {
    pass = 3; // lit part, hidden part, previous azimuth
  }
  else if (!lights.Discs.empty())
  {
    pass = uniform ? 2 : 3;
  }
  else if (this->Quadrature == LINEAR)
  {
    pass = 1;
  }
  return 3 + (this->Horizontal ? 0 : 2) + pass;
}

bool vtkHeightFieldIrradiance::Compute(skyline::HorizonDriver& driver, vtkImageData* output)
{
  using namespace skyline;
  this->SearchedAzimuths = this->EnvironmentPasses = this->SunPasses = this->LampPasses = 0;
  EvenAzimuths(this->NumberOfAzimuths); // throws if out of range
  if (this->LightMethod == HARMONICS)
  {
    CheckHarmonicBands(this->HarmonicBands);
  }
  SortedLights lights;
  for (vtkSkylineLight* light : this->Internals->Lights)
  {
    lights.Add(light, driver);
  }
  if (lights.Count() == 0)
  {
    throw std::invalid_argument("no light shines; add one by AddLight");
  }

  driver.DemandFloats(
    "the light on the posts", this->FloatsOfPasses(lights, driver.Input().Ground().Uniform()), {});
  const auto count = static_cast<std::size_t>(output->GetNumberOfPoints());
  vtkFloatArray* irradiance = skyline::AddPostArray(output, "Irradiance", 3);
  std::fill_n(irradiance->GetPointer(0), 3 * count, 0.0f);
  std::vector<float> gradients;
  LitPosts posts;
  posts.Irradiance = irradiance->GetPointer(0);
  if (!this->Horizontal)
  {
    gradients.resize(2 * count);
    posts.East = gradients.data();
    posts.North = gradients.data() + count;
    driver.Input().FillGradients(gradients.data(), gradients.data() + count);
  }
  HorizonCache& cache = this->Internals->Cache;
  cache.Keep = this->KeepHorizons;
  cache.Searched = 0;
  const std::vector<double> surface = this->SurfaceKey(driver, output);
  cache.SetSurface(surface);

  const bool finished = this->LightMethod == HARMONICS
    ? AddHarmonics(driver, lights, surface, posts)
    : AddTables(driver, lights, posts);
  this->SearchedAzimuths += cache.Searched;
  if (!finished || !AddLamps(driver, lights, output, posts))
  {
    return false;
  }
  const std::ptrdiff_t beyond = skyline::CountNotFinite(driver.Input().Field(), irradiance);
  if (beyond > 0)
  {
    throw std::runtime_error("the light on " + std::to_string(beyond) +
      " posts is more than a float holds (3.4e38); give dimmer lights");
  }
  skyline::BlankMissing(driver.Input().Field(), irradiance);
  return true;
}

bool vtkHeightFieldIrradiance::AddHarmonics(skyline::HorizonDriver& driver,
  const SortedLights& lights, const std::vector<double>& surface, const skyline::LitPosts& posts)
{
  using namespace skyline;
  if (lights.Count() == lights.Lamps.size())
  {
    return true;
  }
  HarmonicLight sum(this->HarmonicBands);
  for (const TurnedLightMap& map : lights.Maps)
  {
    sum.Add(map);
  }
  for (const auto* discs : { &lights.Discs, &lights.LargeDiscs })
  {
    for (const SkyDisc& disc : *discs)
    {
      sum.Add(InMiddle(disc, driver));
    }
  }
  for (vtkSkylineSunLight* sun : lights.Suns)
  {
    sum.Add(DiscOf(sun, driver));
  }

  std::vector<double> key = surface;
  key.insert(key.end(),
    { 1.0 * this->NumberOfAzimuths, 1.0 * this->HarmonicBands, this->Horizontal ? 1.0 : 0.0 });
  return this->LightByHarmonics(driver, sum, key, posts);
}

bool vtkHeightFieldIrradiance::LightByHarmonics(skyline::HorizonDriver& driver,
  const skyline::HarmonicLight& light, const std::vector<double>& key,
  const skyline::LitPosts& posts)
{
  using namespace skyline;
  const Grid& grid = driver.Input().Posts();
  const auto count = static_cast<std::size_t>(grid.Columns * grid.Rows);
  std::vector<float>& transfer = this->Internals->Transfer;
  if (key != this->Internals->TransferKey)
  {
    this->Internals->TransferKey.clear();
    transfer.resize(count * static_cast<std::size_t>(HarmonicCount(this->HarmonicBands)));
    const std::vector<float> level(this->Horizontal ? count : 0, 0.0f);
    HarmonicBuffers buffers;
    buffers.Columns = grid.Columns;
    buffers.Rows = grid.Rows;
    buffers.Bands = this->HarmonicBands;
    buffers.Values = transfer.data();
    VisibilityAccumulator accumulator(buffers, this->Horizontal ? level.data() : posts.East,
      this->Horizontal ? level.data() : posts.North);
    ++this->EnvironmentPasses;
    if (!this->Internals->Cache.Run(driver, EvenAzimuths(this->NumberOfAzimuths),
          2.0 * Pi / this->NumberOfAzimuths, accumulator))
    {
      return false;
    }
    this->Internals->TransferKey = key;
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(count),
    [&](vtkIdType begin, vtkIdType end)
    { light.Light(transfer.data(), begin, end, posts.Irradiance); });
  return true;
}

bool vtkHeightFieldIrradiance::AddTables(
  skyline::HorizonDriver& driver, const SortedLights& lights, const skyline::LitPosts& posts)
{
  using namespace skyline;
  HorizonCache& cache = this->Internals->Cache;
  if (!lights.Maps.empty() || !lights.LargeDiscs.empty())
  {
    std::vector<TurnedLightMap> maps = lights.Maps;
    std::deque<std::vector<float>> drawn;
    for (const SkyDisc& disc : lights.LargeDiscs)
    {
      int columns = 0, rows = 0;
      drawn.push_back(DrawDisc(InMiddle(disc, driver), columns, rows));
      maps.emplace_back();
      maps.back().Map = ViewTopDown(drawn.back().data(), columns, rows);
    }
    const Grid& grid = driver.Input().Posts();
    LightAccumulator::Options options;
    options.Quadrature = static_cast<SwathQuadrature>(this->Quadrature);
    LightAccumulator accumulator(grid.Columns, grid.Rows, maps,
      LightAzimuths(this->NumberOfAzimuths, maps, this->Refine), options, posts.East, posts.North,
      posts.Irradiance);
    std::vector<double> azimuths = accumulator.HorizonAzimuths();
    for (double& azimuth : azimuths)
    {
      // LINEAR passes north a second time at the end; it must be found in the cache.
      azimuth = azimuth >= 2.0 * Pi ? 0.0 : azimuth;
    }
    ++this->EnvironmentPasses;
    if (!cache.Run(driver, azimuths, 0.0, accumulator))
    {
      return false;
    }
  }
  for (const SkyDisc& disc : lights.Discs)
  {
    ++this->SunPasses;
    if (!AddDisc(driver, cache, disc, posts))
    {
      return false;
    }
  }
  for (vtkSkylineSunLight* sun : lights.Suns)
  {
    ++this->SunPasses;
    if (!AddSun(driver, cache, sun, posts))
    {
      return false;
    }
  }
  return true;
}

bool vtkHeightFieldIrradiance::AddLamps(skyline::HorizonDriver& driver, const SortedLights& lights,
  vtkImageData* image, const skyline::LitPosts& posts)
{
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  const skyline::ImageFrame frame{ { { origin[0], origin[1] } }, { { spacing[0], spacing[1] } } };
  double bounds[6];
  image->GetBounds(bounds);
  for (std::size_t i = 0; i < lights.Lamps.size(); ++i)
  {
    vtkSkylineLampLight* const lamp = lights.Lamps[i];
    ++this->LampPasses;
    const double* place = lamp->GetPosition();
    const auto doubt =
      skyline::FarLamp(lights.LampNumbers[i], { place[0], place[1], lamp->GetRadius() },
        { { bounds[0], bounds[1], bounds[2], bounds[3] } });
    if (doubt)
    {
      driver.AddDoubt(*doubt);
    }
    if (!skyline::AddLamp(driver, frame, lamp, posts))
    {
      return false;
    }
  }
  return true;
}
