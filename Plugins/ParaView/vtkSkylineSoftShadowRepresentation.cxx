// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineSoftShadowRepresentation.h"

#include "Color/ToneMap.h"
#include "HarmonicLight.h"
#include "LightFieldData.h"
#include "Shared/Constants.h"
#include "vtkHeightFieldShading.h"
#include "vtkSkylineSoftShadowCompositeMapper.h"
#include "vtkSkylineSoftShadowGeometry.h"
#include "vtkSkylineSoftShadowShader.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPVView.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkSkylineSoftShadowRepresentation);

namespace
{

constexpr int Bands = 4; // of the arrays that the shader reads

// As in vtkHeightFieldShading: AutoLevel, a white ground, is the level that only the brightest 2 %
// of the posts exceed.
constexpr double SampleShare = 0.98;
constexpr vtkIdType LargestSample = 100000;

// The exposure in stops that shows this irradiance best.
double ExposureOf(double irradiance)
{
  return irradiance > 0.0 ? std::log2(vtkHeightFieldShading::AutoLevel * skyline::Pi / irradiance)
                          : 0.0;
}

double ExposureOf(vtkDataArray* irradiance)
{
  std::vector<float> sample;
  const vtkIdType posts = irradiance ? irradiance->GetNumberOfTuples() : 0;
  const vtkIdType step = 1 + posts / LargestSample;
  for (vtkIdType post = 0; post < posts && irradiance->GetNumberOfComponents() == 3; post += step)
  {
    double rgb[3];
    irradiance->GetTuple(post, rgb);
    const float luminance = skyline::Luminance(
      { { static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]) } });
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
  return ExposureOf(static_cast<double>(*place));
}

// The mode of the light that the image contains.
int ModeOf(vtkImageData* image)
{
  vtkPointData* light = image ? image->GetPointData() : nullptr;
  return light && light->HasArray("TransferSH") ? vtkSkylineSoftShadowShader::TRANSFER
    : light && light->HasArray("VisibilitySH")  ? vtkSkylineSoftShadowShader::VISIBILITY
                                                : vtkSkylineSoftShadowShader::IRRADIANCE;
}

} // namespace

vtkSkylineSoftShadowRepresentation::vtkSkylineSoftShadowRepresentation()
  : Geometry(vtkSkylineSoftShadowGeometry::New())
  , LightMode(vtkSkylineSoftShadowGeometry::AUTOMATIC)
{
  this->GeometryFilter->Delete();
  this->GeometryFilter = this->Geometry;
  for (vtkMapper** place : { &this->Mapper, &this->LODMapper })
  {
    auto* mapper = vtkSkylineSoftShadowCompositeMapper::New();
    mapper->SetShader(this->Shader);
    (*place)->Delete();
    *place = mapper;
  }
  this->SetupDefaults();
  this->SetArrayIdNames(nullptr, nullptr);
}

vtkSkylineSoftShadowRepresentation::~vtkSkylineSoftShadowRepresentation() = default;

void vtkSkylineSoftShadowRepresentation::SetElevationArray(const char* name)
{
  this->Geometry->SetElevationArray(name ? name : "");
  this->MarkModified();
}

void vtkSkylineSoftShadowRepresentation::SetExaggeration(double factor)
{
  this->Geometry->SetExaggeration(factor);
  this->MarkModified();
}

void vtkSkylineSoftShadowRepresentation::SetStride(int posts)
{
  this->Geometry->SetStride(posts);
  this->MarkModified();
}

void vtkSkylineSoftShadowRepresentation::SetLightMode(int mode)
{
  this->LightMode = mode;
  this->Geometry->SetMode(mode);
  this->MarkModified();
}

void vtkSkylineSoftShadowRepresentation::SetToneMapping(bool on)
{
  this->Shader->SetToneMapping(on);
}

int vtkSkylineSoftShadowRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

// The first process draws everything.
int vtkSkylineSoftShadowRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out)
{
  this->Superclass::RequestUpdateExtent(request, in, out);
  for (int k = 0; k < in[0]->GetNumberOfInformationObjects(); ++k)
  {
    vtkInformation* info = in[0]->GetInformationObject(k);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

int vtkSkylineSoftShadowRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* in, vtkInformation* out)
{
  const int done = this->Superclass::ProcessViewRequest(request, in, out);
  if (done && request == vtkPVView::REQUEST_RENDER())
  {
    this->UpdateLight();
  }
  return done;
}

// Takes over the light that came with the geometry, and the exposure that suits it.
void vtkSkylineSoftShadowRepresentation::UpdateLight()
{
  vtkDataObject* data = this->Mapper->GetInputDataObject(0, 0);
  if (data != this->LightOf || (data && data->GetMTime() != this->LightTime))
  {
    const auto image = skyline::LoadLight(data);
    this->Shader->SetHeightField(image);
    this->Shader->SetMode(
      this->LightMode == vtkSkylineSoftShadowGeometry::AUTOMATIC ? ModeOf(image) : this->LightMode);
    this->ArrayExposure = image ? ExposureOf(image->GetPointData()->GetArray("Irradiance")) : 0.0;
    this->LightOf = data;
    this->LightTime = data ? data->GetMTime() : 0;
  }
  double exposure = this->ArrayExposure;
  if (this->Shader->GetMode() != vtkSkylineSoftShadowShader::IRRADIANCE)
  {
    skyline::SkyDisc key;
    key.Azimuth = this->KeyAzimuth * skyline::RadiansPerDegree;
    key.Elevation = this->KeyElevation * skyline::RadiansPerDegree;
    key.Radius = this->KeyRadius * skyline::RadiansPerDegree;
    std::copy_n(this->KeyIrradiance, 3, key.Irradiance.begin());
    skyline::HarmonicLight light(Bands);
    light.Add(key);
    const std::vector<double>& sum = light.GetCoefficients();
    constexpr std::size_t count = Bands * Bands;
    const double even = std::sqrt(4.0 * skyline::Pi); // coefficient of the constant function 1
    for (std::size_t i = 0; i < count; ++i)
    {
      const double* sky = this->SkyRadiance;
      const double share = i == 0 ? even : 0.0;
      this->Shader->SetLightCoefficient(static_cast<int>(i), sum[i] + share * sky[0],
        sum[count + i] + share * sky[1], sum[2 * count + i] + share * sky[2]);
    }
    const double rise = std::max(0.0, std::sin(key.Elevation));
    skyline::Rgb ground{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      ground[c] =
        static_cast<float>(skyline::Pi * this->SkyRadiance[c] + rise * this->KeyIrradiance[c]);
    }
    exposure = ExposureOf(static_cast<double>(skyline::Luminance(ground)));
  }
  this->Shader->SetExposure(this->Exposure + (this->AutoExposure ? exposure : 0.0));
}

void vtkSkylineSoftShadowRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LightMode: " << this->LightMode << "\n"
     << indent << "KeyAzimuth: " << this->KeyAzimuth << "\n"
     << indent << "KeyElevation: " << this->KeyElevation << "\n"
     << indent << "KeyRadius: " << this->KeyRadius << "\n"
     << indent << "KeyIrradiance: " << this->KeyIrradiance[0] << " " << this->KeyIrradiance[1]
     << " " << this->KeyIrradiance[2] << "\n"
     << indent << "SkyRadiance: " << this->SkyRadiance[0] << " " << this->SkyRadiance[1] << " "
     << this->SkyRadiance[2] << "\n"
     << indent << "Exposure: " << this->Exposure << "\n"
     << indent << "AutoExposure: " << this->AutoExposure << "\n";
}
