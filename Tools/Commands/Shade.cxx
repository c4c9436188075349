// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Color/Daylight.h"
#include "Failure.h"
#include "Files.h"
#include "LightOptions.h"
#include "Lights.h"
#include "LookOptions.h"
#include "Options.h"
#include "Perspective.h"
#include "PicturePasses.h"
#include "SunLight.h"
#include "Values.h"

#include "vtkHeightFieldAlgorithm.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkHeightFieldShading.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSkylineEnvironmentLight.h"
#include "vtkSkylineSunLight.h"
#include "vtkTrivialProducer.h"

#include <memory>
#include <optional>
#include <string>

namespace
{

struct ShadeCommand
{
  skyline::TerrainOptions Terrain;
  skyline::OutputOptions Output;
  skyline::HorizonOptions Horizon;
  skyline::LightDescription Lights;
  skyline::CommonOptions Common;
  skyline::LookOptions Look;
  std::string View = "map";
  skyline::PerspectiveOptions Perspective;

  void RunPass(vtkAlgorithm* filter, const std::string& title) const
  {
    skyline::RunPass(filter, title, this->Common);
  }

  vtkSmartPointer<vtkImageData> CastShadows(vtkImageData* terrain, vtkSkylineSunLight* sun) const
  {
    const auto shadow = skyline::MakeShadowPass(terrain, this->Horizon);
    shadow->SetSun(sun);
    this->RunPass(shadow, "sun");
    return shadow->GetOutput();
  }

  // Computes how much light of the sky each post gets. Returns the name of the array, and the image
  // with it.
  const char* ViewSky(vtkSmartPointer<vtkImageData>& terrain) const
  {
    const skyline::SkyPass sky = skyline::MakeSkyPass(*this->Lights.Sky, terrain, this->Horizon);
    this->RunPass(sky.Filter, "sky view");
    terrain = sky.Filter->GetOutput();
    return sky.Array;
  }

  void SetExposure(vtkHeightFieldShading* shading) const
  {
    if (this->Look.Exposure)
    {
      shading->AutoExposureOff();
      shading->SetExposure(*this->Look.Exposure);
    }
  }

  void Check(const skyline::UnusedOptions& options) const
  {
    using skyline::PictureFormat;
    using skyline::SkyKind;
    const PictureFormat format = skyline::FormatOf(this->Output.File);
    if (this->View == "perspective" && format != PictureFormat::Png)
    {
      throw skyline::WrongUsage(
        "--output: a perspective view is written as PNG; end its name in .png");
    }
    options.Refuse(this->View != "perspective", { "--size", "--from" },
      "a map is seen from above, with one pixel per post; leave it out, or add --view perspective");
    options.Refuse(format != PictureFormat::Tiff, { "--cloud-optimized" },
      "only a GeoTIFF can be cloud-optimized; leave it out, or name the output .tif");
    options.Refuse(format == PictureFormat::Exr, { "--exposure" },
      "an .exr holds light before exposure; leave it out, or name the output .png or .tif");
    const SkyKind kind = this->Kind();
    this->Horizon.RefuseUnused(options);
    skyline::RefuseUnusedLights(this->Lights, options, kind,
      kind != SkyKind::Map || this->Lights.Sun.Asked(), this->Measured());
    options.Refuse(kind == SkyKind::None, { "--azimuths" },
      "a black sky needs no azimuths; leave it out, or give another --environment");
  }

  skyline::SkyKind Kind() const { return this->Lights.KindOfSky(); }

  // A light map or a measured sky has its own brightness, and a sun only if the user gives one.
  bool Measured() const { return this->Lights.Sky->Measured(); }

  // Adds the array Irradiance for light that is not in the arrays of sun and sky: light maps, skies
  // that are not the same all around (with the colour of the sky), and lamps. Returns false if
  // there is none.
  bool AddFurtherLight(vtkSmartPointer<vtkImageData>& terrain, const skyline::Rgb& sky) const
  {
    skyline::LightDescription wanted = this->Lights;
    if (!skyline::HasEnvironment(this->Kind()))
    {
      wanted.Sky = std::nullopt;
      wanted.Sun = skyline::SunDescription();
      if (wanted.Lamps.empty())
      {
        return false;
      }
    }
    const auto filter = skyline::MakeIrradiancePass(terrain, this->Horizon);
    for (const auto& light : skyline::MakeLights(wanted, terrain, this->Common))
    {
      auto* environment = vtkSkylineEnvironmentLight::SafeDownCast(light);
      if (this->Kind() == skyline::SkyKind::Formula && environment)
      {
        environment->SetRadiance(sky[0], sky[1], sky[2]);
      }
      if (this->Measured() || !vtkSkylineSunLight::SafeDownCast(light))
      {
        filter->AddLight(light);
      }
    }
    this->RunPass(filter, "irradiance");
    terrain = filter->GetOutput();
    return true;
  }

  // Chooses the strength of sun and sky in the shading: that of the day or that given by the user.
  skyline::Daylight ChooseDaylight(const skyline::Center& center, double elevation) const
  {
    if (this->Measured())
    {
      return {};
    }
    const bool air = !center.Place.OnBody() || center.Place.Earth;
    skyline::Daylight day = skyline::ClearDaylight(elevation, air);
    if (this->Lights.Sun.Irradiance && !skyline::SunShines(day))
    {
      skyline::PrintWarning(
        skyline::Doubt{ "--sun-irradiance is given, and the sun is below the horizon",
          "no light of the sun", "" },
        this->Common);
    }
    skyline::ReplaceSun(this->Lights.Sun.Irradiance, day);
    return day;
  }

  void Run() const
  {
    skyline::PrepareVtk(this->Common);
    const skyline::PictureFormat format = skyline::FormatOf(this->Output.File);
    skyline::WarnOfZone(this->Lights.Sun, this->Common);
    skyline::WarnOfTurnedSky(this->Lights, this->Kind(), this->Common);
    skyline::CheckOutput(this->Output.File, { this->Terrain.File, this->Lights.Sky->Text });

    const auto terrain = skyline::Exaggerate(
      skyline::ReadTerrain(this->Terrain, this->Common, this->Output.File), this->Look.Exaggeration,
      [this](vtkAlgorithm* filter, const std::string& title) { this->RunPass(filter, title); });
    this->Horizon.WarnUnused(terrain, this->Common);
    const skyline::Center center = skyline::CenterOf(terrain, this->Common);
    const skyline::SunLight sun = skyline::FindSun(this->Lights.Sun, center.Place, center.Height);
    vtkNew<vtkSkylineSunLight> shared; // used by shadows and shading
    skyline::ApplySun(this->Lights.Sun, sun, shared);

    skyline::Daylight light = this->ChooseDaylight(center, sun.ApparentElevation);
    vtkSmartPointer<vtkImageData> lit = terrain;
    if (skyline::SunShines(light))
    {
      lit = this->CastShadows(lit, shared);
    }
    vtkNew<vtkHeightFieldShading> shading;
    shading->SetSun(shared);
    if (this->AddFurtherLight(lit, light.SkyRadiance))
    {
      shading->SetIrradianceArrayName("Irradiance");
    }
    if (skyline::HasSkyPass(this->Kind()))
    {
      shading->SetSkyArrayName(this->ViewSky(lit));
    }
    else
    {
      light.SkyRadiance = skyline::Rgb{};
    }
    shading->SetInputData(lit);
    shading->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
    skyline::SetDaylight(light, shading);
    shading->SetColorMap(this->Look.Colors);
    this->SetExposure(shading);
    this->RunPass(shading, "shading");

    vtkNew<vtkTrivialProducer> picture;
    picture->SetOutput(shading->GetOutput());
    if (this->View == "perspective")
    {
      const skyline::PerspectiveLight seen{ shading->GetUsedExposure(), light.SkyRadiance };
      picture->SetOutput(
        skyline::DrawPerspective(shading->GetOutput(), seen, this->Perspective, this->Common));
    }
    skyline::WritePicture(picture, format, this->Output, this->Common);
  }
};

} // namespace

namespace skyline
{

void AddShade(CLI::App& program)
{
  CLI::App* app =
    program.add_subcommand("shade", "Draw a picture of the terrain in the light of sun and sky");
  const auto command = std::make_shared<ShadeCommand>();
  command->Horizon.Azimuths = 72;
  app->footer(
    "Without light options, the sun is at azimuth 315, elevation 45 and casts soft shadows, and\n"
    "the sky is uniform. Missing posts are transparent. A .png or .tif file holds the tone-mapped\n"
    "picture (sRGB, 8 bits; .tif with the georeference), an .exr file the linear light before\n"
    "exposure.");
  command->Terrain.AddTo(*app);
  command->Output.AddTo(*app, "Picture to write: .png, .exr or .tif");
  AddSunOptions(*app, command->Lights.Sun);
  AddPictureSkyOption(*app, command->Lights);
  AddLampOptions(*app, command->Lights);
  command->Look.AddTo(*app);
  app
    ->add_option("--view", command->View,
      "map: seen from above, with one pixel per post;\n"
      "perspective: seen from the side, drawn by OpenGL; needs no window system where EGL is\n"
      "available")
    ->check(OneOf({ "map", "perspective" }))
    ->type_name("NAME")
    ->capture_default_str();
  command->Perspective.AddTo(*app);
  command->Horizon.AddTo(*app);
  AddCommonOptions(*app, command->Common);
  RunAfterCheck(*app, command);
}

} // namespace skyline
