// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHeightFieldShading
 * @brief shades a height field as a map picture
 *
 * Colours the heights by a colour map, lights them by a sun and a sky, and tone-maps the result.
 * The input is a 2-D vtkImageData. Its heights, in metres, are the point array chosen by
 * SetInputArrayToProcess(0, ...), by default the active scalars. Two optional point arrays say how
 * much light reaches each post:
 * - SunVisibility, 0 to 1. Without it the sun is never hidden.
 * - The array named by SkyArrayName: the irradiance of the sky divided by pi times its mean
 *   radiance. Without it each post sees as much sky as an open plane with the slope of the post.
 *
 * The output is the input with two more point arrays:
 * - Radiance (float RGB, linear): albedo / pi * (SunIrradiance * SunVisibility * max(0, n.s)
 *   + pi * SkyRadiance * sky), the light that a Lambertian ground sends up; NaN at missing posts;
 * - Picture (unsigned char RGBA, sRGB): Radiance times 2^EV, tone-mapped. No channel reaches 255;
 *   missing posts are transparent black. Picture becomes the active scalars.
 *
 * n is the normal at the post, from central differences (one-sided at the edge and beside missing
 * posts), and s the direction to the sun. Errors are reported by ErrorEvent.
 */
#ifndef vtkHeightFieldShading_h
#define vtkHeightFieldShading_h

#include "SkylineFiltersModule.h" // for the export macro
#include "vtkImageAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSkylineSunLight.h"     // for the methods that set its properties
#include "vtkSmartPointer.h"        // for Sun, LookupTable

#include <string> // for names

namespace skyline
{
class MapLight;
struct GroundColors;
struct MapLights;
} // namespace skyline

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkFloatArray;
class vtkScalarsToColors;

class SKYLINEFILTERS_EXPORT vtkHeightFieldShading : public vtkImageAlgorithm
{
public:
  static vtkHeightFieldShading* New();
  vtkTypeMacro(vtkHeightFieldShading, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the sun: its direction, or its time, and its irradiance (none if its Switch is off). By
   * default the filter has a sun of its own with the irradiance of ClearDaylight(45) in Daylight.h.
   * A sun set here can be shared with other filters. Null gives the filter a new sun.
   */
  void SetSun(vtkSkylineSunLight* sun);
  vtkSkylineSunLight* GetSun() { return this->Sun; }
  ///@}

  ///@{
  /**
   * Set/Get the azimuth of the sun in degrees clockwise from grid north (default 315), and its
   * apparent elevation above the horizontal plane in degrees, -90 to 90 (default 45). Not used with
   * UseTime.
   */
  void SetSunAzimuth(double degrees) { this->Sun->SetAzimuth(degrees); }
  double GetSunAzimuth() { return this->Sun->GetAzimuth(); }
  void SetSunElevation(double degrees) { this->Sun->SetElevation(degrees); }
  double GetSunElevation() { return this->Sun->GetElevation(); }
  ///@}

  ///@{
  /**
   * With UseTime, the direction of the sun is computed for each post, at the moment HoursLater
   * hours after Time. UseTime is off, Time is empty and HoursLater is 0 by default. Time is ISO
   * 8601, and UTC if it names no time zone. The input needs a georeference on the Earth in its
   * field data; without it, or with a time that cannot be read, the update is an error.
   */
  void SetUseTime(bool on) { this->Sun->SetUseTime(on); }
  bool GetUseTime() { return this->Sun->GetUseTime(); }
  void UseTimeOn() { this->SetUseTime(true); }
  void UseTimeOff() { this->SetUseTime(false); }
  void SetTime(const char* time) { this->Sun->SetTime(time); }
  const char* GetTime() { return this->Sun->GetTime(); }
  void SetHoursLater(double hours) { this->Sun->SetHoursLater(hours); }
  double GetHoursLater() { return this->Sun->GetHoursLater(); }
  ///@}

  ///@{
  /**
   * Set/Get the irradiance of a surface that faces the unhidden sun, linear RGB, 0 or more. The
   * default is that of a clear day with the sun at 45 degrees.
   */
  void SetSunIrradiance(double red, double green, double blue)
  {
    this->Sun->SetIrradiance(red, green, blue);
  }
  void SetSunIrradiance(const double rgb[3]) { this->Sun->SetIrradiance(rgb[0], rgb[1], rgb[2]); }
  double* GetSunIrradiance() VTK_SIZEHINT(3) { return this->Sun->GetIrradiance(); }
  ///@}

  ///@{
  /**
   * Set/Get the mean radiance of the sky (its irradiance on open level ground divided by pi),
   * linear RGB, 0 or more. The default is that of a clear day with the sun at 45 degrees.
   */
  vtkSetVector3Macro(SkyRadiance, double);
  vtkGetVector3Macro(SkyRadiance, double);
  ///@}

  ///@{
  /**
   * Set/Get the name of the point array with the irradiance of the sky, divided by pi times
   * SkyRadiance. The default is SkyViewFactor, which suits a uniform sky.
   */
  vtkSetMacro(SkyArrayName, std::string);
  vtkGetMacro(SkyArrayName, std::string);
  ///@}

  ///@{
  /**
   * Set/Get the name of a point array with further irradiance, linear RGB, as
   * vtkHeightFieldIrradiance computes it. It is added to the light of sun and sky. The default is
   * empty: none.
   */
  vtkSetMacro(IrradianceArrayName, std::string);
  vtkGetMacro(IrradianceArrayName, std::string);
  ///@}

  ///@{
  /**
   * Set/Get the name of the colour map: hypsometric (default), ocean, viridis, cividis or gray. An
   * unknown name is an error of the update.
   */
  vtkSetMacro(ColorMap, std::string);
  vtkGetMacro(ColorMap, std::string);
  ///@}

  ///@{
  /**
   * Set/Get the heights of the first and the last colour, in metres. The default is (0, -1). If the
   * first is not below the last, the heights of the lowest and the highest post are used.
   */
  vtkSetVector2Macro(ColorRange, double);
  vtkGetVector2Macro(ColorRange, double);
  ///@}

  ///@{
  /**
   * Set/Get a lookup table that colours the heights instead of the named colour map, over its own
   * range. Its colours are sRGB, as everywhere in VTK. The default is none.
   */
  void SetLookupTable(vtkScalarsToColors* table);
  vtkScalarsToColors* GetLookupTable();
  ///@}

  ///@{
  /**
   * Set/Get whether the exposure is computed from the picture: the 98th percentile of its luminance
   * is set to AutoLevel in the input of ToneMap. The default is on.
   */
  vtkSetMacro(AutoExposure, bool);
  vtkGetMacro(AutoExposure, bool);
  vtkBooleanMacro(AutoExposure, bool);
  ///@}

  ///@{
  /**
   * Set/Get the exposure in stops: light is multiplied by 2 to this power. With AutoExposure it is
   * added to the computed exposure. The default is 0.
   */
  vtkSetMacro(Exposure, double);
  vtkGetMacro(Exposure, double);
  ///@}

  /**
   * Get the exposure in stops that the last update used.
   */
  vtkGetMacro(UsedExposure, double);

  /**
   * The level that AutoExposure gives to the 98th percentile of luminance, in the input of ToneMap.
   */
  static constexpr double AutoLevel = 0.68;

  /// Get the time of the last change of this filter, of its sun or of its lookup table.
  vtkMTimeType GetMTime() override;

protected:
  vtkHeightFieldShading();
  ~vtkHeightFieldShading() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  // Fills the output. Returns false if aborted. Throws std::exception with a reason of one line.
  bool Shade(vtkImageData* in, vtkDataArray* heights, vtkImageData* out);
  vtkSmartPointer<vtkFloatArray> LightPosts(const skyline::MapLight& terrain,
    const skyline::MapLights& lights, const skyline::GroundColors& colors, vtkImageData* image);
  void FindColorRange(vtkDataArray* heights, double range[2]) const;
  vtkDataArray* FindFurtherLight(vtkImageData* image) const;

  vtkSmartPointer<vtkSkylineSunLight> Sun;
  double SkyRadiance[3];
  std::string SkyArrayName = "SkyViewFactor";
  std::string IrradianceArrayName;
  std::string ColorMap = "hypsometric";
  double ColorRange[2] = { 0.0, -1.0 };
  vtkSmartPointer<vtkScalarsToColors> LookupTable;
  bool AutoExposure = true;
  double Exposure = 0.0;
  double UsedExposure = 0.0;

  vtkHeightFieldShading(const vtkHeightFieldShading&) = delete;
  void operator=(const vtkHeightFieldShading&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
