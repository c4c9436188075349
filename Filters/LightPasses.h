// SPDX-License-Identifier: BSD-3-Clause
// The passes of vtkHeightFieldIrradiance: each adds one kind of light to an image of RGB.
#ifndef skyline_LightPasses_h
#define skyline_LightPasses_h

#include "HorizonCache.h"
#include "Shared/Constants.h"
#include "Sky/LightAccumulator.h"
#include "SkylineFiltersModule.h" // for the export macro

#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkSkylineKeyLight;
class vtkSkylineLampLight;
class vtkSkylineSunLight;
VTK_ABI_NAMESPACE_END

namespace skyline
{

class HorizonDriver;
class EclipseField;
class SunField;

/// What a pass reads and writes: gradients and irradiance (three floats) of every post, row by row.
struct LitPosts
{
  const float* East = nullptr; ///< null for level receivers
  const float* North = nullptr;
  float* Irradiance = nullptr;
};

/// A disc in the sky, ready for the kernels: radians; irradiance on an open plane that faces it.
struct SkyDisc
{
  double Azimuth = 0.0, Elevation = 0.0, Radius = 0.0;
  std::array<double, 3> Irradiance{ { 0.0, 0.0, 0.0 } };
};

/// Checked numbers of the lights. std::invalid_argument with a one-line reason.
SkyDisc DiscOf(vtkSkylineSunLight* light);
SkyDisc DiscOf(vtkSkylineKeyLight* light);

/// The same, with UseTime as the sun stands over the middle of the scene; in an eclipse with the light
/// that the Moon leaves there.
SKYLINEFILTERS_EXPORT SkyDisc DiscOf(vtkSkylineSunLight* light, const HorizonDriver& driver);

/// A disc with an azimuth on the image as it stands over the middle of the driver.
SkyDisc InMiddle(SkyDisc disc, const HorizonDriver& driver);

/// LargestSunRadius in radians; larger discs become light maps.
constexpr double LargestSun = LargestSunRadius * RadiansPerDegree;

/// A light map that holds a disc alone, with pixels of a sixteenth of its radius or less.
std::vector<float> DrawDisc(const SkyDisc& disc, int& columns, int& rows);

/// A sun, with the same direction everywhere or by its time, and small key lights. False if stopped.
bool AddSun(
  HorizonDriver& driver, HorizonCache& cache, vtkSkylineSunLight* light, const LitPosts& posts);
bool AddDisc(
  HorizonDriver& driver, HorizonCache& cache, const SkyDisc& disc, const LitPosts& posts);

/// A sun whose direction may differ from post to post; radius and irradiance are the disc's.
bool AddSun(HorizonDriver& driver, HorizonCache& cache, const SunField& sun,
  const EclipseField& eclipse, const SkyDisc& disc, double darkening, const LitPosts& posts);

/// Where an image puts its posts: metres of the south-west one, and between posts.
struct ImageFrame
{
  std::array<double, 2> Origin, Spacing;
};

/// A lamp, whose place counts in the image's coordinates. False if stopped.
bool AddLamp(HorizonDriver& driver, const ImageFrame& image, vtkSkylineLampLight* light,
  const LitPosts& posts);

} // namespace skyline

#endif
