// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHeightFieldShading
 * @brief the map picture of a lit height field
 *
 * Colours heights by a colour map, lights them by a sun and a sky, and tone-maps the result. Input:
 * one 2-D vtkImageData whose heights are the point array chosen by SetInputArrayToProcess(0, ...)
 * (default: the active scalars). Two optional point arrays say what terrain hides:
 * SunVisibility (0 to 1; absent: the sun is never hidden) and the array named by SkyArrayName (the
 * sky's irradiance over pi times its mean radiance; absent: that of a plane with the post's slope).
 *
 * Output: the input with two more point arrays:
 * - Radiance (float RGB, linear light): albedo / pi * (SunIrradiance * SunVisibility * max(0, n.s)
 *   + pi * SkyRadiance * sky), the light a Lambertian ground sends up; NaN at missing posts;
 * - Picture (unsigned char RGBA, sRGB): Radiance times 2^EV through the tone curve; no channel reaches
 *   255; missing posts are transparent black. It becomes the active scalars.
 *
 * The normal comes from central differences, one-sided at the edge and beside missing posts.
 */
#ifndef vtkHeightFieldShading_h
#define vtkHeightFieldShading_h

#include "SkylineFiltersModule.h" // For export macro
#include "vtkImageAlgorithm.h"
#include "vtkSkylineABINamespace.h" // for the ABI namespace
#include "vtkSkylineSunLight.h"     // For the methods that set its properties
#include "vtkSmartPointer.h"        // For Sun, LookupTable

#include <string> // For names

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
   * The sun: a direction, or a time, and its irradiance (none where its Switch is off). The filter has one
   * of its own, with the irradiance of ClearDaylight(45) in Daylight.h; a sun set here can be shared with
   * other filters. Null gives the filter a new one.
   */
  void SetSun(vtkSkylineSunLight* sun);
  vtkSkylineSunLight* GetSun() { return this->Sun; }
  ///@}

  ///@{
  /**
   * Azimuth of the sun, degrees clockwise from grid north (default 315), and apparent elevation above the
   * level ground, degrees, -90 to 90 (default 45). Unused with UseTime.
   */
  void SetSunAzimuth(double degrees) { this->Sun->SetAzimuth(degrees); }
  double GetSunAzimuth() { return this->Sun->GetAzimuth(); }
  void SetSunElevation(double degrees) { this->Sun->SetElevation(degrees); }
  double GetSunElevation() { return this->Sun->GetElevation(); }
  ///@}

  ///@{
  /**
   * With UseTime, the sun's direction is that of the moment HoursLater (default 0) after Time (ISO 8601,
   * UTC without a zone) over each post, by the georeference in the input's field data. Without a place on
   * the Earth, or with a time that cannot be read, an error of the update. Defaults: off, empty.
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
   * Irradiance by the unhidden sun of a surface that faces it, linear RGB, 0 and up. Default: that
   * of a clear day with the sun at 45 degrees.
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
   * Mean radiance of the sky (its irradiance of open level ground over pi), linear RGB, 0 and up.
   * Default: that of a clear day with the sun at 45 degrees.
   */
  vtkSetVector3Macro(SkyRadiance, double);
  vtkGetVector3Macro(SkyRadiance, double);
  ///@}

  ///@{
  /**
   * Name of the point array with the sky's irradiance over pi times SkyRadiance. Default
   * SkyViewFactor, which is that of a uniform sky.
   */
  vtkSetMacro(SkyArrayName, std::string);
  vtkGetMacro(SkyArrayName, std::string);
  ///@}

  ///@{
  /**
   * Name of a point array with further irradiance, linear RGB, as vtkHeightFieldIrradiance makes it;
   * it adds to sun and sky. Default empty: none.
   */
  vtkSetMacro(IrradianceArrayName, std::string);
  vtkGetMacro(IrradianceArrayName, std::string);
  ///@}

  ///@{
  /**
   * Name of the colour map: hypsometric (default), ocean, viridis, cividis or gray. An unknown
   * name is an error of the update.
   */
  vtkSetMacro(ColorMap, std::string);
  vtkGetMacro(ColorMap, std::string);
  ///@}

  ///@{
  /**
   * Heights of the first and last colour, metres. Default (0, -1): where low is not below high, the
   * lowest and highest post.
   */
  vtkSetVector2Macro(ColorRange, double);
  vtkGetVector2Macro(ColorRange, double);
  ///@}

  ///@{
  /**
   * Colours of heights in place of the named map; its range applies. Its colours are sRGB codes, as
   * everywhere in VTK. Default none.
   */
  void SetLookupTable(vtkScalarsToColors* table);
  vtkScalarsToColors* GetLookupTable();
  ///@}

  ///@{
  /**
   * Whether the exposure comes from the picture: the 98th percentile of its luminance is set to
   * AutoLevel in ToneMap's input. Default on.
   */
  vtkSetMacro(AutoExposure, bool);
  vtkGetMacro(AutoExposure, bool);
  vtkBooleanMacro(AutoExposure, bool);
  ///@}

  ///@{
  /**
   * Exposure without AutoExposure, or its correction with it: stops, light is multiplied by 2 to
   * this power. Default 0.
   */
  vtkSetMacro(Exposure, double);
  vtkGetMacro(Exposure, double);
  ///@}

  /**
   * The exposure that the last update used, stops.
   */
  vtkGetMacro(UsedExposure, double);

  /**
   * Level in ToneMap's input that AutoExposure gives the 98th percentile of luminance.
   */
  static constexpr double AutoLevel = 0.68;

  /// The time of the last change of this filter, of its sun or of its lookup table.
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
  // Fills the output; false if stopped. Throws std::exception with a one-line reason.
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
