// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Daylight.h"
#include "Failure.h"
#include "Files.h"
#include "Lights.h"
#include "LookOptions.h"
#include "Options.h"
#include "Perspective.h"
#include "SunLight.h"
#include "ZonalSky.h"

#include "vtkDataArray.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldShading.h"
#include "vtkHeightFieldSkyLight.h"
#include "vtkHeightFieldSkyView.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkImageData.h"
#include "vtkImageShiftScale.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineSunLight.h"
#include "vtkTrivialProducer.h"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace
{

// The number of a sky of CIE S 011, written cie:N.
bool CieType(const std::string& name, int& type)
{
  return name.rfind("cie:", 0) == 0 && CLI::detail::lexical_cast(name.substr(4), type) &&
    type >= 1 && type <= 16;
}

struct ShadeCommand
{
  skyline::TerrainOptions Terrain;
  skyline::OutputOptions Output;
  skyline::HorizonOptions Horizon;
  skyline::SunOptions Sun;
  skyline::LightOptions Lights; // but for environment and sun
  skyline::Talk Talk;
  skyline::LookOptions Look;
  std::string View = "map";
  skyline::PerspectiveOptions Perspective;

  // The heights times the exaggeration, which light and shadow then see.
  vtkSmartPointer<vtkImageData> Exaggerate(vtkImageData* terrain) const
  {
    if (this->Look.Exaggeration == 1.0)
    {
      return terrain;
    }
    vtkNew<vtkImageShiftScale> scale;
    scale->SetInputData(terrain);
    scale->SetScale(this->Look.Exaggeration);
    scale->SetOutputScalarTypeToDouble();
    skyline::RunPass(scale, "exaggeration", this->Talk);
    scale->GetOutput()->GetPointData()->GetScalars()->SetName("Elevation");
    return scale->GetOutput();
  }

  vtkSmartPointer<vtkImageData> CastShadows(
    vtkImageData* terrain, const skyline::SunLight& sun) const
  {
    vtkNew<vtkHeightFieldSunShadow> shadow;
    shadow->SetInputData(terrain);
    this->Horizon.Apply(shadow.Get());
    skyline::ApplySun(this->Sun, sun, shadow);
    skyline::RunPass(shadow, "sun", this->Talk);
    return shadow->GetOutput();
  }

  // The name of the array that says how much light of the sky there is, and the image with it.
  const char* ViewSky(vtkSmartPointer<vtkImageData>& terrain) const
  {
    int type = 0;
    if (CieType(this->Look.Environment, type))
    {
      vtkNew<vtkHeightFieldSkyLight> light;
      light->SetCieType(type);
      this->RunSky(light.Get(), terrain);
      return "SkyLight";
    }
    vtkNew<vtkHeightFieldSkyView> view;
    view->SetSkyViewFactorHorizontal(false);
    view->SetVisibleSkyFraction(false);
    view->SetPositiveOpenness(false);
    this->RunSky(view.Get(), terrain);
    return "SkyViewFactor";
  }

  template <typename Filter>
  void RunSky(Filter* filter, vtkSmartPointer<vtkImageData>& terrain) const
  {
    filter->SetInputData(terrain);
    filter->SetNumberOfAzimuths(this->Horizon.Azimuths);
    this->Horizon.Apply(filter);
    skyline::RunPass(filter, "sky view", this->Talk);
    terrain = filter->GetOutput();
  }

  void SetExposure(vtkHeightFieldShading* shading) const
  {
    if (this->Look.Exposure != "auto")
    {
      double stops = 0.0;
      CLI::detail::lexical_cast(this->Look.Exposure, stops);
      shading->AutoExposureOff();
      shading->SetExposure(stops);
    }
  }

  void CheckOptions(skyline::PictureFormat format) const
  {
    if (this->View == "perspective")
    {
      this->Perspective.Check();
      if (format != skyline::PictureFormat::Png)
      {
        throw skyline::Failure("a perspective picture's name ends in .png");
      }
    }
    this->Look.Check();
  }

  // A light map or a measured sky shines as bright as it is, with a sun only if one is asked for.
  bool Measured() const
  {
    int type = 0;
    return this->Look.Environment != "uniform" && this->Look.Environment != "none" &&
      !CieType(this->Look.Environment, type);
  }

  // A sky by formula that depends on the sun.
  bool Formula() const
  {
    int type = 0;
    return CieType(this->Look.Environment, type) && !skyline::ZonalSky::Knows(type);
  }

  // Adds the array Irradiance of what sun and sky arrays do not hold: light maps, skies that are
  // not the same all around (with the sky's colour), lamps. False if there is none.
  bool AddFurtherLight(vtkSmartPointer<vtkImageData>& terrain, const skyline::Rgb& sky) const
  {
    skyline::LightOptions wanted = this->Lights;
    wanted.Environment = this->Measured() || this->Formula() ? this->Look.Environment : "";
    if (wanted.Environment.empty() && wanted.Lamps.empty())
    {
      return false;
    }
    wanted.Sun = wanted.Environment.empty() ? skyline::SunOptions() : this->Sun;
    vtkNew<vtkHeightFieldIrradiance> filter;
    filter->SetInputData(terrain);
    filter->SetNumberOfAzimuths(this->Horizon.Azimuths);
    this->Horizon.Apply(filter.Get());
    for (const auto& light : skyline::MakeLights(wanted, terrain, this->Talk))
    {
      auto* environment = vtkSkylineEnvironmentLight::SafeDownCast(light);
      if (this->Formula() && environment)
      {
        environment->SetRadiance(sky[0], sky[1], sky[2]);
      }
      if (this->Measured() || !vtkSkylineSunLight::SafeDownCast(light))
      {
        filter->AddLight(light);
      }
    }
    skyline::RunPass(filter, "irradiance", this->Talk);
    terrain = filter->GetOutput();
    return true;
  }

  void Run() const
  {
    skyline::PrepareVtk(this->Talk);
    const skyline::PictureFormat format = skyline::FormatOf(this->Output.File);
    this->CheckOptions(format);
    skyline::CheckOutput(this->Output.File, { this->Terrain.File, this->Look.Environment });

    const auto terrain =
      this->Exaggerate(skyline::ReadTerrain(this->Terrain, this->Talk, this->Output.File));
    const skyline::Center center = skyline::CenterOf(terrain);
    const skyline::SunLight sun = skyline::FindSun(this->Sun, center.Place, center.Height);

    const bool air = !center.Place.OnBody() || center.Place.Earth;
    skyline::Daylight light = skyline::ClearDaylight(sun.ApparentElevation, air);
    vtkSmartPointer<vtkImageData> lit = terrain;
    if (this->Measured())
    {
      light = skyline::Daylight{};
    }
    if (skyline::Luminance(light.SunIrradiance) > 0.0f)
    {
      lit = this->CastShadows(lit, sun);
    }
    vtkNew<vtkHeightFieldShading> shading;
    if (this->AddFurtherLight(lit, light.SkyRadiance))
    {
      shading->SetIrradianceArrayName("Irradiance");
    }
    if (this->Look.Environment == "none" || this->Measured() || this->Formula())
    {
      light.SkyRadiance = skyline::Rgb{};
    }
    else
    {
      shading->SetSkyArrayName(this->ViewSky(lit));
    }
    shading->SetInputData(lit);
    shading->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
    shading->SetSunAzimuth(sun.GridAzimuth);
    shading->SetSunElevation(sun.ApparentElevation);
    shading->SetUseTime(sun.FromTime);
    shading->SetTime(this->Sun.Time);
    shading->SetSunIrradiance(
      light.SunIrradiance[0], light.SunIrradiance[1], light.SunIrradiance[2]);
    shading->SetSkyRadiance(light.SkyRadiance[0], light.SkyRadiance[1], light.SkyRadiance[2]);
    shading->SetColorMap(this->Look.Colors);
    this->SetExposure(shading);
    skyline::RunPass(shading, "shading", this->Talk);

    vtkNew<vtkTrivialProducer> picture;
    picture->SetOutput(shading->GetOutput());
    if (this->View == "perspective")
    {
      const skyline::PerspectiveLight seen{ shading->GetUsedExposure(), light.SkyRadiance };
      picture->SetOutput(
        skyline::DrawPerspective(shading->GetOutput(), seen, this->Perspective, this->Talk));
    }
    skyline::WritePicture(picture, format, this->Output, this->Talk);
  }
};

} // namespace

namespace skyline
{

void AddShade(CLI::App& program)
{
  CLI::App* app = program.add_subcommand("shade", "A picture of the terrain in sun and sky");
  const auto command = std::make_shared<ShadeCommand>();
  command->Horizon.Azimuths = 72;
  app->footer(
    "Without light options: sun from azimuth 315, elevation 45, with soft shadows, under "
    "a uniform sky.\nMissing posts are transparent. .png and .tif hold the tone-mapped "
    "picture (sRGB, 8 bit; .tif with its\nplace on the map), .exr the linear light before "
    "exposure.");
  command->Terrain.AddTo(*app);
  command->Output.AddTo(*app, "Picture to write: .png, .exr or .tif");
  command->Sun.AddTo(*app);
  command->Look.AddSkyTo(*app);
  command->Lights.AddLampsTo(*app);
  command->Look.AddTo(*app);
  app
    ->add_option("--view", command->View,
      "map: seen from above, one pixel a post;\n"
      "perspective: seen from beside, drawn by OpenGL, without a window system where EGL is at hand")
    ->check(CLI::IsMember({ "map", "perspective" }))
    ->type_name("NAME")
    ->capture_default_str();
  command->Perspective.AddTo(*app);
  command->Horizon.AddTo(*app);
  AddTalk(*app, command->Talk);
  app->callback([command] { command->Run(); });
}

} // namespace skyline
