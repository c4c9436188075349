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

/// The passes, and the heights of a field. Errors are std::runtime_error with a reason of one line.
class GpuShadows
{
public:
  GpuShadows(GpuDevice& device, const GpuLimits& limits);

  /// Loads the heights of a closed field, which must fit into one texture.
  void Load(const HeightField& field);

  /// Computes the shadow heights of all posts, row by row: each receiver follows its ray until the
  /// ray is above the highest post. frame: that of ShadowHeightExact. fall: metres that the light
  /// falls per line.
  void Walk(const RayFrame& frame, double fall, std::vector<float>& values);

  /// The recurrence of Lee & Kim: the height of the shadow that arrives at each post, by line and
  /// lane of the frame. Needs OpenGL 4.3.
  void Sweep(const RayFrame& frame, double fall, std::vector<float>& values);

  /// Slopes of the horizon on the lines of a sweep. Needs OpenGL 4.3.
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

/// Receives the reason why the host has to compute.
using GpuFailure = std::function<void(const std::string&)>;

/// The passes of a filter. They are made again when the device has another context.
class GpuShadowPasses
{
public:
  bool OnDevice = false; ///< whether the device computed the last result

  /// Returns the passes with the field loaded, or null if the host has to compute; the filter then
  /// reports the reason once. computes: whether compute shaders are needed. Their absence is not
  /// reported as an error.
  GpuShadows* Open(
    vtkObject* filter, vtkOpenGLHeightFieldDevice* device, const HeightField& field, bool computes);

  /// The function that the methods below call if a pass fails.
  GpuFailure Failure(vtkObject* filter);

private:
  void ReportFallback(vtkObject* filter, const std::string& reason);

  std::unique_ptr<GpuShadows> Passes;
  vtkOpenGLHeightFieldDevice* Device = nullptr;
  int Generation = 0;
  vtkMTimeType Time = 0;
  std::string LastReason;
};

/// The method EXACT of vtkHeightFieldShadowHeight on the graphics processor.
class GpuShadowExact : public ShadowHeightExact
{
public:
  GpuShadowExact(
    GpuShadows& passes, GpuFailure failure, const HeightField& field, double slope, double drop);
  void SetAzimuth(const Grid& grid, double azimuth) override;
  void Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd, float* heights, std::ptrdiff_t stride) const override;

private:
  GpuShadows& Passes;
  GpuFailure Failure;
  double Light;
  std::ptrdiff_t Columns;
  std::vector<float> Values; // empty if the host computes
};

/// The method SWEEP of vtkHeightFieldShadowHeight on the graphics processor.
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

/// The method SWEEP for horizons on the graphics processor.
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
