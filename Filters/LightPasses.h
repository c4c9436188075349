// SPDX-License-Identifier: BSD-3-Clause
// The passes of vtkHeightFieldIrradiance: each adds one type of light to the irradiance of the
// posts.
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

/// The data that a pass reads and writes: gradients and irradiance (three floats) of each post, row
/// by row.
struct LitPosts
{
  const float* East = nullptr; ///< null for level receivers
  const float* North = nullptr;
  float* Irradiance = nullptr;
};

/// A disc in the sky for the kernels: angles in radians, irradiance on an open plane that faces it.
struct SkyDisc
{
  double Azimuth = 0.0, Elevation = 0.0, Radius = 0.0;
  std::array<double, 3> Irradiance{ { 0.0, 0.0, 0.0 } };
};

/// Returns the checked values of a light. Throws std::invalid_argument with a reason of one line.
SkyDisc DiscOf(vtkSkylineSunLight* light);
SkyDisc DiscOf(vtkSkylineKeyLight* light);

/// The same. With UseTime, the disc is that over the middle of the height field, dimmed by an
/// eclipse as there.
SKYLINEFILTERS_EXPORT SkyDisc DiscOf(vtkSkylineSunLight* light, const HorizonDriver& driver);

/// Converts a disc whose azimuth counts on the image to the ground in the middle of the height
/// field.
SkyDisc InMiddle(SkyDisc disc, const HorizonDriver& driver);

/// LargestSunRadius in radians. Larger discs are turned into light maps.
constexpr double LargestSun = LargestSunRadius * RadiansPerDegree;

/// Draws a light map that has only this disc. Its pixels are at most a sixteenth of the radius
/// wide.
std::vector<float> DrawDisc(const SkyDisc& disc, int& columns, int& rows);

/// Adds a small key light, or a sun with one direction or a time. Returns false if stopped.
bool AddSun(
  HorizonDriver& driver, HorizonCache& cache, vtkSkylineSunLight* light, const LitPosts& posts);
bool AddDisc(
  HorizonDriver& driver, HorizonCache& cache, const SkyDisc& disc, const LitPosts& posts);

/// Adds a sun whose direction may differ from post to post; radius and irradiance are those of the
/// disc.
bool AddSun(HorizonDriver& driver, HorizonCache& cache, const SunField& sun,
  const EclipseField& eclipse, const SkyDisc& disc, double darkening, const LitPosts& posts);

/// The position of the posts in an image, in metres: the south-west post and the spacing.
struct ImageFrame
{
  std::array<double, 2> Origin, Spacing;
};

/// Adds a lamp, whose position is in the coordinates of the image. Returns false if stopped.
bool AddLamp(HorizonDriver& driver, const ImageFrame& image, vtkSkylineLampLight* light,
  const LitPosts& posts);

} // namespace skyline

#endif
