// SPDX-License-Identifier: BSD-3-Clause
// Shadow heights and line sweeps on the graphics processor.
#ifndef skyline_GpuShadows_h
#define skyline_GpuShadows_h

#include "GpuCompute.h"
#include "GpuHorizons.h"

#include "Horizon/HorizonSweep.h"
#include "ShadowHeight/ShadowHeight.h"
#include "ShadowHeight/ShadowHeightSweep.h"

#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkType.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
class vtkOpenGLHeightFieldDevice;
VTK_ABI_NAMESPACE_END

namespace skyline
{

/// The passes, and the heights of a field. Errors are std::runtime_error in one line.
class GpuShadows
{
public:
  GpuShadows(GpuDevice& device, const GpuLimits& limits);

  /// The heights of a closed field, which one texture must hold.
  void Load(const HeightField& field);

  /// Shadow heights of all posts, row by row: every receiver walks its ray until it has passed the
  /// highest post. frame: of ShadowHeightExact; fall: metres a line.
  void Walk(const RayFrame& frame, double fall, std::vector<float>& values);

  /// Lee & Kim's recurrence: what reaches each post, by line and lane of the frame. Needs OpenGL 4.3.
  void Sweep(const RayFrame& frame, double fall, std::vector<float>& values);

  /// Slopes on the lines of a sweep. Needs OpenGL 4.3.
  void Hulls(const SweepLines& sweep, std::vector<float>& values);

private:
  GpuDevice& Device;
  GpuLimits Limits;
  GpuTexture Heights;
  int Columns = 0, Rows = 0;
  double Relief = 0.0; // metres
  bool Holes = false;
  std::unique_ptr<GpuPass> WalkPass;
  std::unique_ptr<GpuCompute> SweepPass, HullPass;
};

/// Told why the host has to compute.
using GpuFailure = std::function<void(const std::string&)>;

/// The passes of a filter, made anew where the device has another context.
class GpuShadowSource
{
public:
  bool OnDevice = false; ///< the last result

  /// Passes with the field loaded; null where the host has to compute: the filter reports why, once. computes:
  /// compute shaders are needed; that there are none is no error.
  GpuShadows* Open(
    vtkObject* filter, vtkOpenGLHeightFieldDevice* device, const HeightField& field, bool computes);

  /// What the methods below call if a pass fails.
  GpuFailure Failure(vtkObject* filter);

private:
  void Tell(vtkObject* filter, const std::string& reason);

  std::unique_ptr<GpuShadows> Passes;
  vtkOpenGLHeightFieldDevice* Device = nullptr;
  int Generation = 0;
  vtkMTimeType Time = 0;
  std::string Told;
};

/// Method EXACT of vtkHeightFieldShadowHeight there.
class GpuShadowExact : public ShadowHeightExact
{
public:
  GpuShadowExact(
    GpuShadows& passes, GpuFailure failure, const HeightField& field, double slope, double sink);
  void SetAzimuth(const Grid& grid, double azimuth) override;
  void Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd, float* heights, std::ptrdiff_t stride) const override;

private:
  GpuShadows& Passes;
  GpuFailure Failure;
  double Light;
  std::ptrdiff_t Columns;
  std::vector<float> Values; // empty: the host's
};

/// Method SWEEP of vtkHeightFieldShadowHeight there.
class GpuShadowSweep : public ShadowHeightSweep
{
public:
  GpuShadowSweep(GpuShadows& passes, GpuFailure failure, const HeightField& field, double slope);
  void SetAzimuth(const Grid& grid, double azimuth) override;
  std::ptrdiff_t PrepareCount() const override;

private:
  GpuShadows& Passes;
  GpuFailure Failure;
  bool Done = false;
};

/// Method SWEEP of horizons there.
class GpuHorizonSweep : public HorizonSweep
{
public:
  GpuHorizonSweep(GpuShadows& passes, GpuFailure failure, const HeightField& field,
    const HorizonSettings& settings);
  void SetAzimuth(const Grid& grid, double azimuth) override;
  std::ptrdiff_t PrepareCount() const override;

private:
  GpuShadows& Passes;
  GpuFailure Failure;
  bool Done = false;
};

} // namespace skyline

#endif
