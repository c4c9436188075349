// SPDX-License-Identifier: BSD-3-Clause
// The sky for which the benchmark computes irradiance.
#ifndef skyline_ClearSky_h
#define skyline_ClearSky_h

#include "vtkNew.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSmartPointer.h"

namespace skyline
{
namespace benchmark
{

/// The clear sky of CIE S 011, type 12, without its sun, which is in the south-east.
inline vtkSmartPointer<vtkSkylineEnvironmentLight> MakeClearSky()
{
  vtkNew<vtkSkylineEnvironmentLight> sky;
  sky->SetSourceToCie();
  sky->SetSunAzimuth(131.0);
  sky->SetSunElevation(35.0);
  return sky;
}

} // namespace benchmark
} // namespace skyline

#endif
