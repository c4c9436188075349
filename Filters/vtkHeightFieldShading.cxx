// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldShading.h"

#include "Color/Daylight.h"
#include "Color/ToneMap.h"
#include "HeightArray.h"
#include "MapLight.h"
#include "WholeField.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeightFieldShading);

namespace
{

using skyline::Rgb;

// Rows that one thread takes between two checks of AbortExecute.
constexpr vtkIdType RowsPerStrip = 64;

// Posts that the automatic exposure uses: enough for a steady percentile, few enough to sort.
constexpr vtkIdType LargestSample = 1 << 20;

// The share of lit posts below the level that the automatic exposure sets.
constexpr double SampleShare = 0.98;

// Finds the exposure in stops that brings the percentile of luminance to `level` in the input of
// the tone map.
double FindExposure(const float* radiance, vtkIdType posts, double level)
{
  std::vector<float> sample;
  const vtkIdType step = 1 + posts / LargestSample;
  for (vtkIdType post = 0; post < posts; post += step)
  {
    const float* c = radiance + 3 * post;
    const float luminance = skyline::Luminance(Rgb{ { c[0], c[1], c[2] } });
    if (luminance > 0.0f && std::isfinite(luminance))
    {
      sample.push_back(luminance);
    }
  }
  if (sample.empty())
  {
    return 0.0;
  }
  const auto place = sample.begin() +
    static_cast<std::ptrdiff_t>(SampleShare * static_cast<double>(sample.size() - 1));
  std::nth_element(sample.begin(), place, sample.end());
  return std::log2(level / *place);
}

// Writes tone-mapped sRGB with alpha, four bytes per post.
void Develop(const float* radiance, vtkIdType first, vtkIdType last, float gain, unsigned char* to)
{
  for (vtkIdType post = first; post < last; ++post)
  {
    const float* c = radiance + 3 * post;
    const Rgb tone = skyline::ToneMap(Rgb{ { gain * c[0], gain * c[1], gain * c[2] } });
    for (int k = 0; k < 3; ++k)
    {
      to[4 * post + k] = skyline::SrgbByte(tone[k]);
    }
    to[4 * post + 3] = std::isnan(c[0]) ? 0 : 255;
  }
}

vtkSmartPointer<vtkUnsignedCharArray> MakePicture(
  const float* radiance, vtkIdType posts, double exposure)
{
  auto picture = vtkSmartPointer<vtkUnsignedCharArray>::New();
  picture->SetName("Picture");
  picture->SetNumberOfComponents(4);
  picture->SetNumberOfTuples(posts);
  unsigned char* pixels = picture->GetPointer(0);
  const float gain = static_cast<float>(std::exp2(std::clamp(exposure, -120.0, 120.0)));
  vtkSMPTools::For(0, posts,
    [&](vtkIdType first, vtkIdType last) { Develop(radiance, first, last, gain, pixels); });
  return picture;
}

} // namespace

vtkHeightFieldShading::vtkHeightFieldShading()
{
  this->SetSun(nullptr);
  const skyline::Daylight light = skyline::ClearDaylight(this->Sun->GetElevation());
  std::copy(light.SkyRadiance.begin(), light.SkyRadiance.end(), this->SkyRadiance);
}

vtkHeightFieldShading::~vtkHeightFieldShading() = default;

void vtkHeightFieldShading::SetSun(vtkSkylineSunLight* sun)
{
  if (sun && sun == this->Sun)
  {
    return;
  }
  this->Sun = sun;
  if (!sun)
  {
    this->Sun = vtkSmartPointer<vtkSkylineSunLight>::New();
    const skyline::Rgb light = skyline::ClearDaylight(this->Sun->GetElevation()).SunIrradiance;
    this->Sun->SetIrradiance(light[0], light[1], light[2]);
  }
  this->Modified();
}

void vtkHeightFieldShading::SetLookupTable(vtkScalarsToColors* table)
{
  if (this->LookupTable != table)
  {
    this->LookupTable = table;
    this->Modified();
  }
}

vtkScalarsToColors* vtkHeightFieldShading::GetLookupTable()
{
  return this->LookupTable;
}

vtkMTimeType vtkHeightFieldShading::GetMTime()
{
  const vtkMTimeType own = std::max(this->Superclass::GetMTime(), this->Sun->GetMTime());
  return this->LookupTable ? std::max(own, this->LookupTable->GetMTime()) : own;
}

int vtkHeightFieldShading::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkHeightFieldShading::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkDataObject::SetPointDataActiveScalarInfo(
    output->GetInformationObject(0), VTK_UNSIGNED_CHAR, 4);
  return 1;
}

// The colours span all heights, so a part of the picture needs the whole terrain.
int vtkHeightFieldShading::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  skyline::RequestWhole(input[0]->GetInformationObject(0));
  return 1;
}

int vtkHeightFieldShading::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkImageData* in = vtkImageData::GetData(input[0]);
  vtkDataArray* heights = this->GetInputArrayToProcess(0, input);
  bool finished = false;
  const std::string failure = skyline::ReasonOfFailure(in,
    [&]
    {
      skyline::CheckWhole(input[0]->GetInformationObject(0));
      skyline::CheckSurface(in);
      skyline::CheckHeights(in, heights);
      finished = this->Shade(in, heights, vtkImageData::GetData(output));
    });
  if (!failure.empty())
  {
    vtkErrorMacro(<< failure);
    return 0;
  }
  if (finished)
  {
    skyline::KeepPiece(output->GetInformationObject(0));
    this->UpdateProgress(1.0);
  }
  return 1;
}

void vtkHeightFieldShading::FindColorRange(vtkDataArray* heights, double range[2]) const
{
  std::copy_n(this->ColorRange, 2, range);
  if (!(range[0] < range[1]))
  {
    heights->GetFiniteRange(range, 0);
  }
}

vtkDataArray* vtkHeightFieldShading::FindFurtherLight(vtkImageData* image) const
{
  vtkDataArray* light = image->GetPointData()->GetArray(this->IrradianceArrayName.c_str());
  if (light &&
    (light->GetNumberOfComponents() != 3 ||
      light->GetNumberOfTuples() != image->GetNumberOfPoints()))
  {
    throw std::invalid_argument("the array " + this->IrradianceArrayName + " has " +
      std::to_string(light->GetNumberOfTuples()) + " x " +
      std::to_string(light->GetNumberOfComponents()) + " values; irradiance needs " +
      std::to_string(image->GetNumberOfPoints()) + " x 3, as vtkHeightFieldIrradiance makes it");
  }
  return light;
}

vtkSmartPointer<vtkFloatArray> vtkHeightFieldShading::LightPosts(const skyline::MapLight& terrain,
  const skyline::MapLights& lights, const skyline::GroundColors& colors, vtkImageData* image)
{
  auto radiance = vtkSmartPointer<vtkFloatArray>::New();
  radiance->SetName("Radiance");
  radiance->SetNumberOfComponents(3);
  radiance->SetNumberOfTuples(image->GetNumberOfPoints());
  float* light = radiance->GetPointer(0);
  const vtkIdType rows = image->GetDimensions()[1];
  const vtkIdType strips = (rows + RowsPerStrip - 1) / RowsPerStrip;
  const auto lightStrips = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType strip = first; strip < last && !this->GetAbortExecute(); ++strip)
    {
      terrain.LightRows(
        lights, colors, strip * RowsPerStrip, std::min(rows, (strip + 1) * RowsPerStrip), light);
    }
  };
  if (colors.Table)
  {
    lightStrips(0, strips); // MapValue writes to a member of the table: use one thread
  }
  else
  {
    vtkSMPTools::For(0, strips, 1, lightStrips);
  }
  this->UpdateProgress(0.6);
  return this->GetAbortExecute() ? nullptr : radiance;
}

bool vtkHeightFieldShading::Shade(vtkImageData* in, vtkDataArray* heights, vtkImageData* out)
{
  const skyline::ColorMap* map = skyline::FindColorMap(this->ColorMap);
  if (!map && !this->LookupTable)
  {
    throw std::invalid_argument("no colour map named " + this->ColorMap);
  }
  double range[2];
  this->FindColorRange(heights, range);
  if (this->LookupTable)
  {
    this->LookupTable->SetRange(range);
    this->LookupTable->Build();
  }
  const skyline::GroundColors colors{ map, this->LookupTable, range[0], range[1] };
  const double* sun = this->Sun->GetIrradiance();
  const double shines = this->Sun->GetSwitch() ? 1.0 : 0.0;
  const skyline::MapLights lights{ { { shines * sun[0], shines * sun[1], shines * sun[2] } },
    { { this->SkyRadiance[0], this->SkyRadiance[1], this->SkyRadiance[2] } },
    in->GetPointData()->GetArray("SunVisibility"),
    in->GetPointData()->GetArray(this->SkyArrayName.c_str()), this->FindFurtherLight(in) };
  const skyline::MapLight terrain(in, heights, this->Sun);

  const auto radiance = this->LightPosts(terrain, lights, colors, in);
  if (!radiance)
  {
    return false;
  }
  const float* light = radiance->GetPointer(0);
  const vtkIdType posts = radiance->GetNumberOfTuples();
  this->UsedExposure =
    this->Exposure + (this->AutoExposure ? FindExposure(light, posts, AutoLevel) : 0.0);
  out->ShallowCopy(in);
  out->GetPointData()->AddArray(radiance);
  out->GetPointData()->AddArray(MakePicture(light, posts, this->UsedExposure));
  out->GetPointData()->SetActiveScalars("Picture"); // SetScalars would drop the heights
  return true;
}

void vtkHeightFieldShading::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto triple = [&](const char* name, const double* v)
  { os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  os << indent << "Sun:\n";
  this->Sun->PrintSelf(os, indent.GetNextIndent());
  triple("SkyRadiance", this->SkyRadiance);
  os << indent << "SkyArrayName: " << this->SkyArrayName << "\n";
  os << indent << "IrradianceArrayName: " << this->IrradianceArrayName << "\n";
  os << indent << "ColorMap: " << this->ColorMap << "\n";
  os << indent << "ColorRange: " << this->ColorRange[0] << " " << this->ColorRange[1] << "\n";
  os << indent << "LookupTable: " << this->LookupTable.GetPointer() << "\n";
  os << indent << "AutoExposure: " << this->AutoExposure << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "UsedExposure: " << this->UsedExposure << "\n";
}
