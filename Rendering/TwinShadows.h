// SPDX-License-Identifier: BSD-3-Clause
// Shadow heights and line sweeps on the graphics processor.
#ifndef skyline_TwinShadows_h
#define skyline_TwinShadows_h

#include "TwinCompute.h"
#include "TwinHorizons.h"

#include "HorizonSweep.h"
#include "ShadowHeight.h"
#include "ShadowHeightSweep.h"

#include "vtkType.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkObject;
class vtkOpenGLHeightFieldDevice;

namespace skyline
{

/// The passes, and the heights of a field. Errors are std::runtime_error in one line.
class TwinShadows
{
public:
  TwinShadows(TwinDevice& device, const TwinLimits& limits);

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
  TwinDevice& Device;
  TwinLimits Limits;
  TwinTexture Heights;
  int Columns = 0, Rows = 0;
  double Relief = 0.0; // metres
  bool Holes = false;
  std::unique_ptr<TwinPass> WalkPass;
  std::unique_ptr<TwinCompute> SweepPass, HullPass;
};

/// Told why the host has to compute.
using TwinFailure = std::function<void(const std::string&)>;

/// The passes of a filter, made anew where the device has another context.
class TwinShadowSource
{
public:
  bool OnDevice = false; ///< the last result

  /// Passes with the field loaded; null where the host has to compute: the filter reports why, once. computes:
  /// compute shaders are needed; that there are none is no error.
  TwinShadows* Open(
    vtkObject* filter, vtkOpenGLHeightFieldDevice* device, const HeightField& field, bool computes);

  /// What the methods below call if a pass fails.
  TwinFailure Failure(vtkObject* filter);

private:
  void Tell(vtkObject* filter, const std::string& reason);

  std::unique_ptr<TwinShadows> Passes;
  vtkOpenGLHeightFieldDevice* Device = nullptr;
  int Generation = 0;
  vtkMTimeType Time = 0;
  std::string Told;
};

/// Method EXACT of vtkShadowHeightMap there.
class TwinShadowExact : public ShadowHeightExact
{
public:
  TwinShadowExact(
    TwinShadows& passes, TwinFailure failure, const HeightField& field, double slope, double sink);
  void SetAzimuth(const Grid& grid, double azimuth) override;
  void Find(std::ptrdiff_t lineBegin, std::ptrdiff_t lineEnd, std::ptrdiff_t laneBegin,
    std::ptrdiff_t laneEnd, float* heights, std::ptrdiff_t stride) const override;

private:
  TwinShadows& Passes;
  TwinFailure Failure;
  double Light;
  std::ptrdiff_t Columns;
  std::vector<float> Values; // empty: the host's
};

/// Method SWEEP of vtkShadowHeightMap there.
class TwinShadowSweep : public ShadowHeightSweep
{
public:
  TwinShadowSweep(TwinShadows& passes, TwinFailure failure, const HeightField& field, double slope);
  void SetAzimuth(const Grid& grid, double azimuth) override;
  std::ptrdiff_t PrepareCount() const override;

private:
  TwinShadows& Passes;
  TwinFailure Failure;
  bool Done = false;
};

/// Method SWEEP of horizons there.
class TwinHorizonSweep : public HorizonSweep
{
public:
  TwinHorizonSweep(TwinShadows& passes, TwinFailure failure, const HeightField& field,
    const HorizonSettings& settings);
  void SetAzimuth(const Grid& grid, double azimuth) override;
  std::ptrdiff_t PrepareCount() const override;

private:
  TwinShadows& Passes;
  TwinFailure Failure;
  bool Done = false;
};

} // namespace skyline

#endif
