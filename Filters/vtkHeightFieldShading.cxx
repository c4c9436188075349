// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldShading.h"

#include "Color/ColorMaps.h"
#include "Color/Daylight.h"
#include "Color/ToneMap.h"
#include "Data/ImageGeoreference.h"
#include "Geo/GroundMetric.h"
#include "HeightField/BaseHeight.h"
#include "HeightField/Normals.h"
#include "Shared/Constants.h"
#include "Sun/SunField.h"
#include "WholeField.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <vector>

vtkStandardNewMacro(vtkHeightFieldShading);

namespace
{

using skyline::Rgb;

// Rows that one thread takes at a time, between two looks at AbortExecute.
constexpr vtkIdType RowsPerStrip = 64;

// Posts that the automatic exposure looks at: enough for a steady percentile, few enough to sort.
constexpr vtkIdType LargestSample = 1 << 20;

// The share of lit posts below the level that the automatic exposure sets.
constexpr double SampleShare = 0.98;

constexpr double Nothing = std::numeric_limits<double>::quiet_NaN();

template <typename Value>
void CopyRow(const Value* values, vtkIdType count, double* heights)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double height = static_cast<double>(values[i]);
    heights[i] = std::isfinite(height) ? height : Nothing;
  }
}

// The heights of an image and the distances between them.
struct Terrain
{
  vtkDataArray* Heights;
  vtkIdType Columns, Rows;
  skyline::PostSpacing Spacing;
  skyline::Georeference Place;
  std::unique_ptr<skyline::GroundMetric> Metric;

  // Heights of one row, NaN where missing; all NaN outside the image.
  void Read(vtkIdType row, double* heights) const
  {
    if (row < 0 || row >= this->Rows)
    {
      std::fill_n(heights, this->Columns, Nothing);
      return;
    }
    switch (this->Heights->GetDataType())
    {
      vtkTemplateMacro(
        CopyRow(static_cast<const VTK_TT*>(this->Heights->GetVoidPointer(row * this->Columns)),
          this->Columns, heights));
    }
  }

  // For the parallax and air of the sun, which hardly depend on it.
  double MeanHeight() const
  {
    double range[2];
    this->Heights->GetFiniteRange(range, 0);
    return range[0] <= range[1]
      ? skyline::BaseHeight(this->Heights->GetNumberOfTuples(), range[0], range[1],
          [this](std::ptrdiff_t post) { return this->Heights->GetComponent(post, 0); })
      : 0.0;
  }
};

// What shines on all posts.
struct Lights
{
  const double* SunIrradiance;
  const double* SkyRadiance;
  vtkDataArray* SunVisibility; // may be null
  vtkDataArray* Sky;           // may be null
  vtkDataArray* Further;       // irradiance, may be null
};

// Irradiance over pi of a post with slopes east and north and a sun in direction x, y, z.
Rgb Light(const Lights& lights, vtkIdType post, double east, double north, const float* sun)
{
  const double up = 1.0 / std::sqrt(1.0 + east * east + north * north);
  const double facing = std::max(0.0, up * (sun[2] - east * sun[0] - north * sun[1]));
  const double lit = lights.SunVisibility ? lights.SunVisibility->GetComponent(post, 0) : 1.0;
  const double sky = lights.Sky ? lights.Sky->GetComponent(post, 0) : 0.5 * (1.0 + up);
  Rgb light;
  for (int c = 0; c < 3; ++c)
  {
    light[c] = static_cast<float>(lights.SunIrradiance[c] * lit * facing / skyline::Pi +
      lights.SkyRadiance[c] * sky +
      (lights.Further ? lights.Further->GetComponent(post, c) / skyline::Pi : 0.0));
  }
  return light;
}

// Heights to albedo: a named map by table, or VTK's colours.
struct Ground
{
  const skyline::ColorMap* Map;
  vtkScalarsToColors* Table;
  double Low, High;

  Rgb operator()(double height) const
  {
    if (!this->Table)
    {
      return skyline::ColorAt(
        *this->Map, skyline::PlaceOnMap(*this->Map, height, this->Low, this->High));
    }
    const unsigned char* color = this->Table->MapValue(height);
    return Rgb{ { skyline::DecodeSrgb(color[0] / 255.0f), skyline::DecodeSrgb(color[1] / 255.0f),
      skyline::DecodeSrgb(color[2] / 255.0f) } };
  }
};

// Radiance of rows [first, last), three floats a post; NaN where the height is missing.
void LightRows(const Terrain& terrain, const Lights& lights, const skyline::SunField& sun,
  const Ground& ground, vtkIdType first, vtkIdType last, float* radiance)
{
  const vtkIdType columns = terrain.Columns;
  std::vector<double> lines(static_cast<std::size_t>(3 * columns));
  double* south = lines.data();
  double* here = south + columns;
  double* north = here + columns;
  std::vector<float> directions(static_cast<std::size_t>(3 * columns));
  float* x = directions.data();
  float* y = x + columns;
  float* z = y + columns;
  for (vtkIdType row = first; row < last; ++row)
  {
    terrain.Read(row - 1, south);
    terrain.Read(row, here);
    terrain.Read(row + 1, north);
    sun.Row(row, 0, columns, x, y, z);
    const bool alike = terrain.Metric->Uniform() || terrain.Metric->ByRows();
    const skyline::PostMetric ofRow = terrain.Metric->At(0.0, static_cast<double>(row));
    for (vtkIdType i = 0; i < columns; ++i)
    {
      const skyline::PostMetric metric =
        alike ? ofRow : terrain.Metric->At(static_cast<double>(i), static_cast<double>(row));
      const vtkIdType post = row * columns + i;
      float* to = radiance + 3 * post;
      if (std::isnan(here[i]))
      {
        std::fill_n(to, 3, std::numeric_limits<float>::quiet_NaN());
        continue;
      }
      const double west = i > 0 ? here[i - 1] : Nothing;
      const double east = i + 1 < columns ? here[i + 1] : Nothing;
      const float toSun[3] = { x[i], y[i], z[i] };
      const Rgb albedo = ground(here[i]);
      const double slopeY = skyline::AxisGradient(south[i], here[i], north[i], metric.Y);
      // A column lies a little further north than the one before where the map is sheared.
      const double slopeX =
        skyline::AxisGradient(west, here[i], east, metric.X) - slopeY * metric.Shear / metric.X;
      const Rgb light = Light(lights, post, slopeX, slopeY, toSun);
      for (int c = 0; c < 3; ++c)
      {
        to[c] = albedo[c] * light[c];
      }
    }
  }
}

// The exposure in stops that gives the percentile of luminance the level of the tone map's input.
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

// Tone-mapped sRGB with alpha, four bytes a post.
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

} // namespace

vtkHeightFieldShading::vtkHeightFieldShading()
{
  const skyline::Daylight light = skyline::ClearDaylight(this->SunElevation);
  std::copy(light.SunIrradiance.begin(), light.SunIrradiance.end(), this->SunIrradiance);
  std::copy(light.SkyRadiance.begin(), light.SkyRadiance.end(), this->SkyRadiance);
}

vtkHeightFieldShading::~vtkHeightFieldShading() = default;

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
  const vtkMTimeType own = this->Superclass::GetMTime();
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
  vtkImageData* out = vtkImageData::GetData(output);
  vtkDataArray* heights = this->GetInputArrayToProcess(0, input);
  if (!heights)
  {
    vtkErrorMacro("no heights: the image has no point scalars");
    return 0;
  }
  int size[3];
  in->GetDimensions(size);
  const vtkIdType columns = size[0];
  const vtkIdType rows = size[1];
  const vtkIdType posts = columns * rows;
  if (size[2] != 1 || columns < 2 || rows < 2)
  {
    vtkErrorMacro("no surface: " << columns << " x " << rows << " x " << size[2]
                                 << " posts; a height field has at least 2 x 2 x 1");
    return 0;
  }
  if (heights->GetNumberOfComponents() != 1 || heights->GetNumberOfTuples() != posts)
  {
    vtkErrorMacro("no heights: the array is not one number a post");
    return 0;
  }
  const skyline::ColorMap* map = skyline::FindColorMap(this->ColorMap);
  if (!map && !this->LookupTable)
  {
    vtkErrorMacro("no colour map named " << this->ColorMap);
    return 0;
  }

  Terrain terrain{ heights, columns, rows, { in->GetSpacing()[0], in->GetSpacing()[1] }, {},
    nullptr };
  skyline::SunField sun = skyline::SunField::Constant(0.0, 90.0, 0.0);
  try
  {
    skyline::CheckWhole(input[0]->GetInformationObject(0));
    terrain.Place = skyline::GeoreferenceOf(in);
    terrain.Metric = std::make_unique<skyline::GroundMetric>(terrain.Place, terrain.Spacing);
    terrain.Place.GroundAxes = !terrain.Metric->Uniform();
    sun = this->UseTime
      ? skyline::SunField(terrain.Place, skyline::ParseUtcTime(this->Time), terrain.MeanHeight())
      : skyline::SunField::OnImage(terrain.Place, this->SunAzimuth, this->SunElevation, 0.0);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }

  vtkDataArray* further = in->GetPointData()->GetArray(this->IrradianceArrayName.c_str());
  if (further && (further->GetNumberOfComponents() != 3 || further->GetNumberOfTuples() != posts))
  {
    vtkErrorMacro("no irradiance: the array is not three numbers a post");
    return 0;
  }
  const Lights lights{ this->SunIrradiance, this->SkyRadiance,
    in->GetPointData()->GetArray("SunVisibility"),
    in->GetPointData()->GetArray(this->SkyArrayName.c_str()), further };
  double range[2] = { this->ColorRange[0], this->ColorRange[1] };
  if (!(range[0] < range[1]))
  {
    heights->GetFiniteRange(range, 0);
  }
  if (this->LookupTable)
  {
    this->LookupTable->SetRange(range);
    this->LookupTable->Build();
  }
  const Ground ground{ map, this->LookupTable, range[0], range[1] };

  vtkNew<vtkFloatArray> radiance;
  radiance->SetName("Radiance");
  radiance->SetNumberOfComponents(3);
  radiance->SetNumberOfTuples(posts);
  float* light = radiance->GetPointer(0);
  const vtkIdType strips = (rows + RowsPerStrip - 1) / RowsPerStrip;
  const auto lightStrips = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType strip = first; strip < last && !this->GetAbortExecute(); ++strip)
    {
      LightRows(terrain, lights, sun, ground, strip * RowsPerStrip,
        std::min(rows, (strip + 1) * RowsPerStrip), light);
    }
  };
  if (this->LookupTable)
  {
    lightStrips(0, strips); // MapValue writes to a member of the table: one thread
  }
  else
  {
    vtkSMPTools::For(0, strips, 1, lightStrips);
  }
  this->UpdateProgress(0.6);
  if (this->GetAbortExecute())
  {
    return 1;
  }

  this->UsedExposure =
    this->Exposure + (this->AutoExposure ? FindExposure(light, posts, AutoLevel) : 0.0);
  const float gain = static_cast<float>(std::exp2(std::clamp(this->UsedExposure, -120.0, 120.0)));
  vtkNew<vtkUnsignedCharArray> picture;
  picture->SetName("Picture");
  picture->SetNumberOfComponents(4);
  picture->SetNumberOfTuples(posts);
  unsigned char* pixels = picture->GetPointer(0);
  vtkSMPTools::For(
    0, posts, [&](vtkIdType first, vtkIdType last) { Develop(light, first, last, gain, pixels); });

  out->ShallowCopy(in);
  out->GetPointData()->AddArray(radiance);
  out->GetPointData()->AddArray(picture);
  out->GetPointData()->SetActiveScalars("Picture"); // SetScalars would drop the heights
  skyline::KeepPiece(output->GetInformationObject(0));
  this->UpdateProgress(1.0);
  return 1;
}

void vtkHeightFieldShading::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto triple = [&](const char* name, const double* v)
  { os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  os << indent << "SunAzimuth: " << this->SunAzimuth << "\n";
  os << indent << "SunElevation: " << this->SunElevation << "\n";
  os << indent << "UseTime: " << this->UseTime << "\n";
  os << indent << "Time: " << this->Time << "\n";
  triple("SunIrradiance", this->SunIrradiance);
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
