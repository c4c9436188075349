// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightFieldAlgorithm
 * @brief   base class of the filters that search horizons of a height field
 *
 * The input is a vtkImageData with one slice and at least 2 x 2 posts. The heights are a point
 * array with one component, in metres: the array chosen by SetInputArrayToProcess, by default the
 * active scalars. x points east and y north; row 0 is the southern edge. NaN and infinite heights
 * mark missing posts. If the field data hold a georeference (see vtkHeightFieldReader), the filter
 * uses it for curvature, refraction, the spacing of each row and true north.
 *
 * The output is the input with further point arrays of type float, NaN at missing posts. The
 * results do not depend on the number of threads.
 *
 * Each error is reported by one ErrorEvent with a text of one line. The output is then empty.
 */
#ifndef vtkHeightFieldAlgorithm_h
#define vtkHeightFieldAlgorithm_h

#include "SkylineFiltersModule.h"
#include "vtkImageAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace

#include <memory> // for Pyramids
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

  /// The methods that find horizons. Documentation/architecture.md describes them, and
  /// Documentation/benchmark.md compares them.
  enum MethodType
  {
    EXACT = 0,  ///< uses every edge of the surface that can matter
    FAST = 1,   ///< at most 0.25 degrees below the exact horizon
    SWEEP = 2,  ///< Timonen & Westerholm 2010, resampled; can be off by degrees
    PYRAMID = 3 ///< Snyder & Nowrouzezahrai 2008: smooth, off by about a degree, never below 0
  };
  /// The surface that is assumed between the posts.
  enum SurfaceType
  {
    TRIANGLES = 0, ///< each cell is split from post (i, j) to post (i + 1, j + 1)
    BILINEAR = 1   ///< each cell is a bilinear patch
  };

  ///@{
  /// Set/Get the method that finds horizons. The default is EXACT. Other values are clamped to
  /// EXACT ... PYRAMID.
  vtkSetClampMacro(Method, int, EXACT, PYRAMID);
  vtkGetMacro(Method, int);
  void SetMethodToExact() { this->SetMethod(EXACT); }
  void SetMethodToFast() { this->SetMethod(FAST); }
  void SetMethodToSweep() { this->SetMethod(SWEEP); }
  void SetMethodToPyramid() { this->SetMethod(PYRAMID); }
  ///@}

  ///@{
  /// Set/Get the surface between the posts. The default is TRIANGLES. SWEEP and PYRAMID support
  /// TRIANGLES only; BILINEAR with them is an error of the update.
  vtkSetClampMacro(Surface, int, TRIANGLES, BILINEAR);
  vtkGetMacro(Surface, int);
  void SetSurfaceToTriangles() { this->SetSurface(TRIANGLES); }
  void SetSurfaceToBilinear() { this->SetSurface(BILINEAR); }
  ///@}

  ///@{
  /// Ignore the curvature of the body, and refraction. The default is off. A height field without a
  /// georeference is always treated as flat.
  vtkSetMacro(Flat, bool);
  vtkGetMacro(Flat, bool);
  vtkBooleanMacro(Flat, bool);
  ///@}

  ///@{
  /// Set/Get the coefficient k of terrestrial refraction: terrain at distance d appears lower by
  /// (1 - k) d^2 / 2R. It is used on the Earth only. The default is 0.13; the range is -100 to
  /// below 1. Other values are an error of the update.
  vtkSetMacro(RefractionCoefficient, double);
  vtkGetMacro(RefractionCoefficient, double);
  ///@}

  ///@{
  /// Set/Get by how many degrees a horizon of EXACT may lie too low, for the sake of speed. The
  /// default is 0, the range 0 to 90. With a tolerance above 0 (FAST always has 0.25) the result
  /// within the tolerance depends on the instruction set of the processor; with 0 it does not.
  vtkSetClampMacro(Tolerance, double, 0.0, 90.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// Set/Get the parameters of PYRAMID (Snyder & Nowrouzezahrai 2008). Values out of range are an
  /// error of the update.
  /// - LevelStep (k): number of levels per octave, 1 to 16, default 4.
  /// - LevelOffset (o): by how many octaves sharper the levels are that are read, 0 to 64, default
  ///   2.
  /// - LevelDistance (lambda): number of samples to the place where a level is read, above 0 to 64,
  ///   default 1.
  /// - LevelSpline: whether a b-spline over log distance is used, default on. If off, only the
  ///   greatest level counts, which is cheaper.
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
  /// Get how many seconds the last execution spent on the preparation of bounds, and on the search
  /// together with the evaluation of the horizons.
  vtkGetMacro(PrepareSeconds, double);
  vtkGetMacro(SearchSeconds, double);
  ///@}

  /// Get the number of pyramids that the last execution built (PYRAMID only). A pyramid is reused
  /// as long as the heights do not change and the method stays PYRAMID.
  vtkGetMacro(PyramidBuilds, int);

protected:
  vtkHeightFieldAlgorithm();
  ~vtkHeightFieldAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

  /// Adds the arrays of the filter to `output`, which already holds the data of the input. Returns
  /// false if aborted. Throws std::exception with a reason of one line.
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
