// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Color/Daylight.h"
#include "Failure.h"
#include "Files.h"
#include "IdleOptions.h"
#include "Lights.h"
#include "LookOptions.h"
#include "Options.h"
#include "Perspective.h"
#include "SkyNames.h"
#include "SunLight.h"
#include "Values.h"

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

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

namespace
{

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
    if (skyline::CieType(this->Look.Environment, type))
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
    if (this->Look.Exposure)
    {
      shading->AutoExposureOff();
      shading->SetExposure(*this->Look.Exposure);
    }
  }

  void Check(const skyline::IdleOptions& options) const
  {
    using skyline::PictureFormat;
    using skyline::SkyKind;
    const PictureFormat format = skyline::FormatOf(this->Output.File);
    if (this->View == "perspective" && format != PictureFormat::Png)
    {
      throw skyline::WrongUsage("--output: a perspective picture's name ends in .png");
    }
    options.Refuse(this->View != "perspective", { "--size", "--from" },
      "a map has a pixel a post, seen from above; leave it out, or add --view perspective");
    options.Refuse(format != PictureFormat::Tiff, { "--cloud-optimized" },
      "only a GeoTIFF can be; leave it out, or name the output .tif");
    options.Refuse(format == PictureFormat::Exr, { "--exposure" },
      "an .exr holds light before exposure; leave it out, or name the output .png or .tif");
    const SkyKind kind = this->Kind();
    this->Horizon.RefuseIdle(options);
    skyline::LightOptions lights = this->Lights;
    lights.Sun = this->Sun;
    lights.RefuseIdle(options, kind, kind != SkyKind::Map || this->Sun.Asked(), this->Measured());
    options.Refuse(kind == SkyKind::None, { "--azimuths" },
      "a black sky needs none; leave it out, or give another --environment");
  }

  skyline::SkyKind Kind() const { return skyline::KindOfSky(this->Look.Environment); }

  // A light map or a measured sky shines as bright as it is, with a sun only if one is asked for.
  bool Measured() const { return skyline::IsMeasured(this->Kind()); }

  // A sky by formula that depends on the sun.
  bool Formula() const { return this->Kind() == skyline::SkyKind::Formula; }

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

  // The sun's own light in place of the day's; none for a sun that is down, however strong.
  void ReplaceSun(const std::array<double, 3>& irradiance, skyline::Daylight& light) const
  {
    if (skyline::Luminance(light.SunIrradiance) > 0.0f)
    {
      std::transform(irradiance.begin(), irradiance.end(), light.SunIrradiance.begin(),
        [](double part) { return static_cast<float>(part); });
      return;
    }
    skyline::PrintWarning(
      skyline::Doubt{
        "--sun-irradiance is given, and the sun is below the horizon", "no light of the sun", "" },
      this->Talk);
  }

  void Run() const
  {
    skyline::PrepareVtk(this->Talk);
    const skyline::PictureFormat format = skyline::FormatOf(this->Output.File);
    this->Sun.WarnOfZone(this->Talk);
    skyline::LightOptions lights = this->Lights;
    lights.Environment = this->Look.Environment;
    lights.WarnOfTurnedSky(this->Kind(), this->Talk);
    skyline::CheckOutput(this->Output.File, { this->Terrain.File, this->Look.Environment });

    const auto terrain =
      this->Exaggerate(skyline::ReadTerrain(this->Terrain, this->Talk, this->Output.File));
    this->Horizon.WarnIdle(terrain, this->Talk);
    const skyline::Center center = skyline::CenterOf(terrain, this->Talk);
    const skyline::SunLight sun = skyline::FindSun(this->Sun, center.Place, center.Height);

    const bool air = !center.Place.OnBody() || center.Place.Earth;
    skyline::Daylight light = skyline::ClearDaylight(sun.ApparentElevation, air);
    vtkSmartPointer<vtkImageData> lit = terrain;
    if (this->Measured())
    {
      light = skyline::Daylight{};
    }
    else if (const auto asked = skyline::AskedSunIrradiance(this->Lights))
    {
      this->ReplaceSun(*asked, light);
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
    ->check(OneOf({ "map", "perspective" }))
    ->type_name("NAME")
    ->capture_default_str();
  command->Perspective.AddTo(*app);
  command->Horizon.AddTo(*app);
  AddTalk(*app, command->Talk);
  app->callback(
    [command, app]
    {
      command->Check(IdleOptions(*app));
      command->Run();
    });
}

} // namespace skyline
