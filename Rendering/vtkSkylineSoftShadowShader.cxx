// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkylineSoftShadowShader.h"

#include "ShaderText.h"
#include "Shared/Constants.h"
#include "SoftShadowText.h"
#include "SoftShadowTextures.h"
#include "SurfaceLight.h"
#include "VertexRow.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkSkylineSoftShadowShader);

namespace
{

constexpr std::size_t Lamps = 4;

} // namespace

struct vtkSkylineSoftShadowShader::Internals : skyline::SoftShadowTextures
{
  vtkSmartPointer<vtkAlgorithm> Producer; // of the height field; may be null
  int Port = 0;
  skyline::SurfaceLight Light{};
  std::array<skyline::LightColor, Lamps> LampRadiance{};
  std::vector<float> PackedLight; // empty if it has to be packed again
  vtkTimeStamp TextTime;
  std::string Reported; // why the last Prepare failed

  // Updates the height field. Returns a reason as SoftShadowTextures does.
  std::string UpdateImage(vtkOpenGLRenderWindow* window)
  {
    if (this->Producer)
    {
      this->Producer->Update();
      this->Image = vtkImageData::SafeDownCast(this->Producer->GetOutputDataObject(this->Port));
    }
    return this->Image && this->Image->GetNumberOfPoints() > 0
      ? this->CheckImage(window)
      : "no height field to light the terrain: SetHeightField";
  }
};

vtkSkylineSoftShadowShader::vtkSkylineSoftShadowShader()
  : Internal(std::make_unique<Internals>())
{
  this->SetUniformLight(1.0, 1.0, 1.0);
  this->Internal->TextTime.Modified();
}

vtkSkylineSoftShadowShader::~vtkSkylineSoftShadowShader() = default;

void vtkSkylineSoftShadowShader::SetMode(int mode)
{
  mode = std::clamp(mode, static_cast<int>(IRRADIANCE), static_cast<int>(RECEIVER));
  if (this->Mode != mode)
  {
    this->Mode = mode;
    this->Internal->PackedLight.clear();
    this->Internal->TextTime.Modified();
    this->Modified();
  }
}

void vtkSkylineSoftShadowShader::SetToneMapping(bool on)
{
  if (this->ToneMapping != on)
  {
    this->ToneMapping = on;
    this->Internal->TextTime.Modified();
    this->Modified();
  }
}

void vtkSkylineSoftShadowShader::SetLinearTextures(bool on)
{
  if (this->LinearTextures != on)
  {
    this->LinearTextures = on;
    this->Internal->TextTime.Modified();
    this->Modified();
  }
}

void vtkSkylineSoftShadowShader::SetLinearFramebuffer(bool on)
{
  if (this->LinearFramebuffer != on)
  {
    this->LinearFramebuffer = on;
    this->Internal->TextTime.Modified();
    this->Modified();
  }
}

void vtkSkylineSoftShadowShader::SetHeightField(vtkImageData* image)
{
  if (this->Internal->Image != image || this->Internal->Producer)
  {
    this->Internal->Image = image;
    this->Internal->Producer = nullptr;
    this->Modified();
  }
}

vtkImageData* vtkSkylineSoftShadowShader::GetHeightField()
{
  return this->Internal->Image;
}

void vtkSkylineSoftShadowShader::SetHeightFieldConnection(vtkAlgorithmOutput* output)
{
  this->Internal->Producer = output ? output->GetProducer() : nullptr;
  this->Internal->Port = output ? output->GetIndex() : 0;
  this->Internal->Image = nullptr;
  this->Modified();
}

void vtkSkylineSoftShadowShader::SetIrradianceTexture(vtkTextureObject* texture)
{
  if (this->Internal->IrradianceTexture != texture)
  {
    this->Internal->IrradianceTexture = texture;
    this->Modified();
  }
}

vtkTextureObject* vtkSkylineSoftShadowShader::GetIrradianceTexture()
{
  return this->Internal->IrradianceTexture;
}

void vtkSkylineSoftShadowShader::SetLightCoefficient(
  int index, double red, double green, double blue)
{
  if (index < 0 || index >= static_cast<int>(skyline::LightCoefficients))
  {
    vtkErrorMacro("no light coefficient " << index << ": 0 to " << skyline::LightCoefficients - 1);
    return;
  }
  this->Internal->Light[static_cast<std::size_t>(index)] = { { red, green, blue } };
  this->Internal->PackedLight.clear();
  this->Modified();
}

void vtkSkylineSoftShadowShader::GetLightCoefficient(int index, double rgb[3])
{
  const bool known = index >= 0 && index < static_cast<int>(skyline::LightCoefficients);
  const skyline::LightColor color =
    known ? this->Internal->Light[static_cast<std::size_t>(index)] : skyline::LightColor{};
  std::copy(color.begin(), color.end(), rgb);
}

void vtkSkylineSoftShadowShader::SetUniformLight(double red, double green, double blue)
{
  this->Internal->Light = skyline::SurfaceLight{};
  const double y = std::sqrt(4.0 * skyline::Pi); // the coefficient of the constant function 1
  this->SetLightCoefficient(0, y * red, y * green, y * blue);
}

void vtkSkylineSoftShadowShader::SetLampRadiance(int lamp, double red, double green, double blue)
{
  if (lamp < 0 || lamp >= static_cast<int>(Lamps))
  {
    vtkErrorMacro("no lamp " << lamp << ": 0 to " << Lamps - 1);
    return;
  }
  const bool before = this->HasLamps();
  this->Internal->LampRadiance[static_cast<std::size_t>(lamp)] = { { red, green, blue } };
  if (this->HasLamps() != before)
  {
    this->Internal->TextTime.Modified();
  }
  this->Modified();
}

void vtkSkylineSoftShadowShader::GetLampRadiance(int lamp, double rgb[3])
{
  const bool known = lamp >= 0 && lamp < static_cast<int>(Lamps);
  const skyline::LightColor color =
    known ? this->Internal->LampRadiance[static_cast<std::size_t>(lamp)] : skyline::LightColor{};
  std::copy(color.begin(), color.end(), rgb);
}

bool vtkSkylineSoftShadowShader::HasLamps()
{
  return std::any_of(this->Internal->LampRadiance.begin(), this->Internal->LampRadiance.end(),
    [](const skyline::LightColor& color) { return color != skyline::LightColor{}; });
}

bool vtkSkylineSoftShadowShader::Prepare(vtkOpenGLRenderWindow* window)
{
  const std::string reason = this->Upload(window);
  if (reason != this->Internal->Reported && !reason.empty())
  {
    vtkErrorMacro(<< reason);
  }
  this->Internal->Reported = reason;
  return reason.empty();
}

std::string vtkSkylineSoftShadowShader::Upload(vtkOpenGLRenderWindow* window)
{
  Internals& in = *this->Internal;
  in.InUse.clear();
  std::string reason = in.UpdateImage(window);
  if (!reason.empty())
  {
    return reason;
  }
  in.Place();
  switch (this->Mode)
  {
    case IRRADIANCE:
      reason = in.SendIrradiance(this->IrradianceArrayName, window);
      break;
    case TRANSFER:
      reason = in.SendHarmonics(this->TransferArrayName, window);
      break;
    case VISIBILITY:
      reason = in.SendHarmonics(this->VisibilityArrayName, window);
      reason = reason.empty() ? in.SendGradients(this->ElevationArrayName, window) : reason;
      break;
    default:
      reason = in.SendReceiver(window);
  }
  if (reason.empty() && this->HasLamps())
  {
    vtkDataArray* array = in.Find(this->LampArrayName, 1, static_cast<int>(Lamps));
    reason = array ? in.Send(in.LampLight, window, array, 0, array->GetNumberOfComponents(), false)
                   : in.Missing(this->LampArrayName, "1 to 4");
  }
  return reason;
}

void vtkSkylineSoftShadowShader::ReplaceShaderValues(
  const std::map<vtkShader::Type, vtkShader*>& shaders, int normals)
{
  skyline::SoftShadowText text;
  switch (this->Mode)
  {
    case RECEIVER:
      // Must come first: the text that follows is inserted before this text.
      text.Irradiance = this->Internal->Receiver.AddText(
        shaders, static_cast<skyline::ReceiverLight::Normals>(normals));
      break;
    case IRRADIANCE:
      text.Irradiance = skyline::ShaderPart(skyline_Irradiance);
      break;
    case TRANSFER:
      text.Irradiance = skyline::ShaderPart(skyline_Transfer);
      break;
    default:
      text.Irradiance = skyline::ShaderPart(skyline_Visibility);
  }
  text.Lamps = this->HasLamps();
  text.ToneMapping = this->ToneMapping;
  text.LinearTextures = this->LinearTextures;
  text.LinearFramebuffer = this->LinearFramebuffer;
  skyline::AddSoftShadows(shaders, text);
}

void vtkSkylineSoftShadowShader::Activate()
{
  for (skyline::PostTexture* texture : this->Internal->InUse)
  {
    texture->Activate();
  }
}

void vtkSkylineSoftShadowShader::Deactivate()
{
  for (skyline::PostTexture* texture : this->Internal->InUse)
  {
    texture->Deactivate();
  }
}

void vtkSkylineSoftShadowShader::SetUniforms(
  vtkShaderProgram* program, vtkOpenGLVertexBufferObjectGroup* buffers)
{
  Internals& in = *this->Internal;
  for (skyline::PostTexture* texture : in.InUse)
  {
    if (program->IsUniformUsed(texture->GetUniform().c_str()))
    {
      program->SetUniformi(texture->GetUniform().c_str(), texture->GetUnit());
    }
  }
  const bool receiver = this->Mode == RECEIVER;
  skyline::SetVertexRow(
    program, buffers, "skylineAcross", receiver ? in.Placed(in.Across) : in.Across);
  skyline::SetVertexRow(program, buffers, "skylineUp", receiver ? in.Placed(in.Up) : in.Up);
  program->SetUniformf("skylineGain",
    static_cast<float>(std::exp2(std::clamp(this->Exposure, -120.0, 120.0)) / skyline::Pi));
  if (receiver)
  {
    in.Receiver.SetUniforms(program, buffers, in.Placement, skyline::OpenSky(in.Light));
  }
  else if (this->Mode != IRRADIANCE)
  {
    if (in.PackedLight.empty())
    {
      in.PackedLight = this->Mode == TRANSFER ? skyline::PackTransferLight(in.Light)
                                              : skyline::PackVisibilityLight(in.Light);
    }
    program->SetUniform4fv(
      "skylineLight", static_cast<int>(in.PackedLight.size() / 4), in.PackedLight.data());
  }
  if (this->HasLamps())
  {
    std::array<float, 3 * Lamps> radiance{};
    for (std::size_t k = 0; k < radiance.size(); ++k)
    {
      radiance[k] = static_cast<float>(in.LampRadiance[k / 3][k % 3]);
    }
    program->SetUniform3fv("skylineLampRadiance", static_cast<int>(Lamps), radiance.data());
  }
}

void vtkSkylineSoftShadowShader::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  in.InUse.clear();
  in.Irradiance.Release(window);
  in.Gradient.Release(window);
  in.LampLight.Release(window);
  in.Receiver.Texture.Release(window);
  for (skyline::PostTexture& texture : in.Harmonics)
  {
    texture.Release(window);
  }
}

void vtkSkylineSoftShadowShader::SetSunIrradiance(double red, double green, double blue)
{
  this->Internal->Receiver.Sun = { { red, green, blue } };
  this->Modified();
}

void vtkSkylineSoftShadowShader::GetSunIrradiance(double rgb[3])
{
  std::copy(this->Internal->Receiver.Sun.begin(), this->Internal->Receiver.Sun.end(), rgb);
}

void vtkSkylineSoftShadowShader::SetPenumbraDepth(double depth)
{
  if (this->Internal->Receiver.PenumbraDepth != depth)
  {
    this->Internal->Receiver.PenumbraDepth = depth;
    this->Modified();
  }
}

double vtkSkylineSoftShadowShader::GetPenumbraDepth()
{
  return this->Internal->Receiver.PenumbraDepth;
}

void vtkSkylineSoftShadowShader::SetPlacement(vtkMatrix4x4* matrix)
{
  if (matrix)
  {
    this->Internal->Placement->DeepCopy(matrix);
  }
  else
  {
    this->Internal->Placement->Identity();
  }
}

int vtkSkylineSoftShadowShader::GetNumberOfTextureUploads()
{
  return this->Internal->Uploads;
}

vtkMTimeType vtkSkylineSoftShadowShader::GetTextTime()
{
  return this->Internal->TextTime;
}

void vtkSkylineSoftShadowShader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "HeightField: " << this->Internal->Image.GetPointer() << "\n";
  os << indent << "IrradianceArrayName: " << this->IrradianceArrayName << "\n";
  os << indent << "TransferArrayName: " << this->TransferArrayName << "\n";
  os << indent << "VisibilityArrayName: " << this->VisibilityArrayName << "\n";
  os << indent << "LampArrayName: " << this->LampArrayName << "\n";
  os << indent << "ElevationArrayName: " << this->ElevationArrayName << "\n";
  const auto print = [&](const char* name, const skyline::LightColor& color)
  { os << indent << name << ": " << color[0] << " " << color[1] << " " << color[2] << "\n"; };
  for (const skyline::LightColor& coefficient : this->Internal->Light)
  {
    print("LightCoefficient", coefficient);
  }
  for (const skyline::LightColor& radiance : this->Internal->LampRadiance)
  {
    print("LampRadiance", radiance);
  }
  print("SunIrradiance", this->Internal->Receiver.Sun);
  os << indent << "IrradianceTexture: " << this->Internal->IrradianceTexture.GetPointer() << "\n";
  os << indent << "PenumbraDepth: " << this->Internal->Receiver.PenumbraDepth << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "ToneMapping: " << this->ToneMapping << "\n";
  os << indent << "LinearTextures: " << this->LinearTextures << "\n";
  os << indent << "LinearFramebuffer: " << this->LinearFramebuffer << "\n";
  os << indent << "Uploads: " << this->Internal->Uploads << "\n";
}
