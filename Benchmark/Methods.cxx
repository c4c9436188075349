// SPDX-License-Identifier: BSD-3-Clause
#include "Methods.h"

#include "EmbreeHorizon.h"
#include "EveryCrossing.h"
#include "FusedSkyView.h"
#include "GrassHorizon.h"
#include "Horizon/HorizonExact.h"
#include "KernelMethods.h"

#include <sstream>

namespace skyline
{
namespace benchmark
{

namespace
{

constexpr double LooseTolerance = 0.05; // degrees

Method OfSettings(const char* name, const char* label, HorizonMethodKind kind, double tolerance)
{
  HorizonSettings settings;
  settings.Method = kind;
  settings.Tolerance = tolerance * RadiansPerDegree;
  const MakeMethod make = [settings](const HeightField& field)
  { return MakeHorizonMethod(field, settings); };
  return { name, label,
    [make](const Scene& scene, const ReferenceHorizons& truth, const Plan& plan)
    { return MeasureKernel(scene, truth, make, plan.Repeats); } };
}

// The cheaper pyramid of Snyder & Nowrouzezahrai (2008), for environment light.
Method OfLevels(const char* name, const char* label)
{
  HorizonSettings settings;
  settings.Method = HorizonMethodKind::Pyramid;
  settings.Pyramid.Spline = false;
  const MakeMethod make = [settings](const HeightField& field)
  { return MakeHorizonMethod(field, settings); };
  return { name, label,
    [make](const Scene& scene, const ReferenceHorizons& truth, const Plan& plan)
    { return MeasureKernel(scene, truth, make, plan.Repeats); } };
}

Result MeasureEveryCrossing(const Scene& scene, const ReferenceHorizons& truth, const Plan& plan)
{
  const MakeMethod make = [](const HeightField& field)
  { return std::make_unique<EveryCrossing>(field, HorizonSettings()); };
  return MeasureKernel(scene, truth, make, plan.Repeats, plan.Thin);
}

Method OfEmbree(const char* name, const char* label, double accuracy)
{
  return { name, label,
    [accuracy](const Scene& scene, const ReferenceHorizons& truth, const Plan& plan)
    { return MeasureEmbree(scene, truth, accuracy, plan.Repeats); } };
}

} // namespace

const std::vector<Method>& Methods()
{
  static const std::vector<Method> methods{
    OfSettings("exact", "exact", HorizonMethodKind::Exact, 0.0),
    OfSettings("tolerance", "exact, 0.05 deg", HorizonMethodKind::Exact, LooseTolerance),
    OfSettings("fast", "fast", HorizonMethodKind::Fast, 0.0),
    OfSettings("sweep", "sweep", HorizonMethodKind::Sweep, 0.0),
    OfSettings("pyramid", "pyramid", HorizonMethodKind::Pyramid, 0.0),
    OfLevels("pyramidmax", "pyramid, max alone"),
    { "every", "every crossing", MeasureEveryCrossing },
    OfEmbree("embree0.25", "Embree 0.25 deg", 0.25),
    OfEmbree("embree0.01", "Embree 0.01 deg", 0.01),
    { "grass", "GRASS r.horizon",
      [](const Scene& scene, const ReferenceHorizons& truth, const Plan& plan)
      { return MeasureGrass(scene, truth, plan.GrassAzimuths); } },
    { "skyview", "exact + sky view",
      [](const Scene& scene, const ReferenceHorizons& truth, const Plan& plan)
      { return MeasureFusedSkyView(scene, truth, plan.Repeats); } },
  };
  return methods;
}

std::string DescribeMethods()
{
  std::ostringstream text;
  text
    << "exact            each edge of " << ExactState::NearLines << " near lines, then segments of "
    << SegmentBounds::Lines << " lines in groups of " << SegmentBounds::PerGroup
    << " segments, skipped if their bounds allow it\n"
    << "exact, 0.05 deg  the same, may lie lower by " << LooseTolerance << " degrees\n"
    << "fast             the same, may lie lower by " << FastTolerance * DegreesPerRadian
    << " degrees\n"
    << "sweep            Timonen & Westerholm 2010, resampled\n"
    << "pyramid          Snyder & Nowrouzezahrai 2008, k = 4, o = 2; no horizon below 0\n"
    << "every crossing   plain float loops over all edges, vectorised by the compiler\n"
    << "Embree           occlusion rays on one thread; the bracket grows from the previous azimuth "
       "and is halved until its width is\n                 twice the accuracy; behind missing posts "
       "a ray may pass below the rim\n"
    << "GRASS r.horizon  the whole raster, in a few azimuths\n"
    << "exact + sky view from the image to four sky quantities, as in the filter\n";
  return text.str();
}

} // namespace benchmark
} // namespace skyline
