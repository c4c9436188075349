// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldAlgorithm
 * @brief   what the filters on horizons of a height field have in common
 *
 * Input: a vtkImageData of one slice with one point scalar a post (SetInputArrayToProcess; the active
 * scalars by default), metres; x points east, y north, row 0 is the south edge; at least 2 x 2
 * posts. NaN and infinite posts are missing. A georeference in the field data (vtkHeightFieldReader)
 * brings curvature, refraction, the spacing of every row and true north. Output: the input and the
 * result arrays, float, NaN at missing posts. Results do not depend on the number of threads.
 *
 * Errors are reported by ErrorEvent in one line; the output then is empty.
 */
#ifndef vtkHeightFieldAlgorithm_h
#define vtkHeightFieldAlgorithm_h

#include "SkylineFiltersModule.h"
#include "vtkImageAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <memory> // For Pyramids
#include <string>

namespace skyline
{
class HorizonDriver;
class HorizonInput;
class PyramidCache;
struct HorizonSettings;
} // namespace skyline
VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;

class SKYLINEFILTERS_EXPORT vtkHeightFieldAlgorithm : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkHeightFieldAlgorithm, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The ways to find horizons; Documentation/horizon.md compares them.
  enum MethodType
  {
    EXACT = 0,  ///< every edge of the surface that can matter
    FAST = 1,   ///< below the exact horizon by 0.25 degrees at most
    SWEEP = 2,  ///< Timonen & Westerholm 2010 as published, resampled: off by degrees at places
    PYRAMID = 3 ///< Snyder & Nowrouzezahrai 2008: smooth, off by a degree, horizons of 0 at least
  };
  /// The surfaces through the posts.
  enum SurfaceType
  {
    TRIANGLES = 0, ///< each cell split from its (i, j) to its (i + 1, j + 1) post
    BILINEAR = 1   ///< each cell a bilinear patch
  };

  ///@{
  /// How horizons are found; default EXACT.
  vtkSetClampMacro(Method, int, EXACT, PYRAMID);
  vtkGetMacro(Method, int);
  void SetMethodToExact() { this->SetMethod(EXACT); }
  void SetMethodToFast() { this->SetMethod(FAST); }
  void SetMethodToSweep() { this->SetMethod(SWEEP); }
  void SetMethodToPyramid() { this->SetMethod(PYRAMID); }
  ///@}

  ///@{
  /// The surface through the posts; default TRIANGLES. SWEEP and PYRAMID know no other.
  vtkSetClampMacro(Surface, int, TRIANGLES, BILINEAR);
  vtkGetMacro(Surface, int);
  void SetSurfaceToTriangles() { this->SetSurface(TRIANGLES); }
  void SetSurfaceToBilinear() { this->SetSurface(BILINEAR); }
  ///@}

  ///@{
  /// Leaves the body's curvature and refraction out; default off. Without a georeference the field
  /// is flat anyway.
  vtkSetMacro(Flat, bool);
  vtkGetMacro(Flat, bool);
  vtkBooleanMacro(Flat, bool);
  ///@}

  ///@{
  /// Terrestrial refraction k: a post at distance d sinks by (1 - k) d^2 / 2R. Counts on the Earth
  /// alone; default 0.13, -100 to below 1.
  vtkSetMacro(RefractionCoefficient, double);
  vtkGetMacro(RefractionCoefficient, double);
  ///@}

  ///@{
  /// Degrees by which EXACT may fall short of the horizon, for speed; default 0, 0 to 90. What is found
  /// within the tolerance (FAST: 0.25) depends on the processor's instruction set; with 0 it does not.
  vtkSetClampMacro(Tolerance, double, 0.0, 90.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// The parameters of PYRAMID (Snyder & Nowrouzezahrai 2008). LevelStep k: levels an octave, 1 to 16,
  /// default 4; LevelOffset o: octaves by which sharper levels are read, 0 or more, default 2;
  /// LevelDistance lambda: samples to where a level is read, default 1; LevelSpline: the b-spline over
  /// log distance, default on; off: the greatest level alone, cheaper.
  vtkSetMacro(LevelStep, double);
  vtkGetMacro(LevelStep, double);
  vtkSetMacro(LevelOffset, double);
  vtkGetMacro(LevelOffset, double);
  vtkSetMacro(LevelDistance, double);
  vtkGetMacro(LevelDistance, double);
  vtkSetMacro(LevelSpline, bool);
  vtkGetMacro(LevelSpline, bool);
  vtkBooleanMacro(LevelSpline, bool);
  ///@}

  ///@{
  /// Seconds that the last execution took: preparation of bounds, and search with its consumers.
  vtkGetMacro(PrepareSeconds, double);
  vtkGetMacro(SearchSeconds, double);
  ///@}

  /// Pyramids that the last execution built (PYRAMID). Heights that did not change keep theirs, as long
  /// as the method is PYRAMID.
  vtkGetMacro(PyramidBuilds, int);

protected:
  vtkHeightFieldAlgorithm();
  ~vtkHeightFieldAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

  /// Adds the filter's arrays to `output`, which holds the input's data. Returns false if aborted;
  /// throws std::exception with a one-line reason.
  virtual bool Compute(skyline::HorizonDriver& driver, vtkImageData* output) = 0;

  int Method = EXACT;
  int Surface = TRIANGLES;
  bool Flat = false;
  double RefractionCoefficient;
  double Tolerance = 0.0;
  double LevelStep = 4.0;
  double LevelOffset = 2.0;
  double LevelDistance = 1.0;
  bool LevelSpline = true;
  double PrepareSeconds = 0.0;
  double SearchSeconds = 0.0;
  int PyramidBuilds = 0;

private:
  void Search(vtkImageData* input, vtkDataArray* heights, vtkImageData* output);

  vtkHeightFieldAlgorithm(const vtkHeightFieldAlgorithm&) = delete;
  void operator=(const vtkHeightFieldAlgorithm&) = delete;

  skyline::HorizonSettings Settings(const skyline::HorizonInput& surface) const;

  std::unique_ptr<skyline::PyramidCache> Pyramids;
};
VTK_ABI_NAMESPACE_END

#endif
