// SPDX-License-Identifier: BSD-3-Clause
#include "SoftShadowTextures.h"

#include "PostValues.h"
#include "SurfaceLight.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"

#include <exception>
#include <sstream>

namespace skyline
{

namespace
{

std::string ReasonUnless(bool sent)
{
  return sent ? "" : "OpenGL refuses the textures of the height field";
}

} // namespace

std::string SoftShadowTextures::CheckImage(vtkOpenGLRenderWindow* window) const
{
  const int* size = this->Image->GetDimensions();
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  if (size[2] != 1)
  {
    return "the height field is not a 2-D image";
  }
  if (size[0] > limit || size[1] > limit)
  {
    std::ostringstream text;
    text << size[0] << " x " << size[1] << " posts exceed the largest texture of this OpenGL, "
         << limit << " x " << limit << "; light a part or a coarser height field";
    return text.str();
  }
  return {};
}

void SoftShadowTextures::Place()
{
  const double(*index)[4] = this->Image->GetPhysicalToIndexMatrix()->Element;
  const int* extent = this->Image->GetExtent();
  const int* size = this->Image->GetDimensions();
  for (std::size_t k = 0; k < 4; ++k)
  {
    const double shift = k == 3 ? 0.5 : 0.0;
    const double first = k == 3 ? 1.0 : 0.0;
    this->Across[k] = (index[0][k] - first * extent[0] + shift) / size[0];
    this->Up[k] = (index[1][k] - first * extent[2] + shift) / size[1];
  }
}

VertexRow SoftShadowTextures::Placed(const VertexRow& row) const
{
  VertexRow placed{};
  for (int column = 0; column < 4; ++column)
  {
    for (int k = 0; k < 4; ++k)
    {
      placed[static_cast<std::size_t>(column)] +=
        row[static_cast<std::size_t>(k)] * this->Placement->GetElement(k, column);
    }
  }
  return placed;
}

vtkDataArray* SoftShadowTextures::Find(const std::string& name, int least, int most) const
{
  vtkDataArray* array = this->Image->GetPointData()->GetArray(name.c_str());
  return array && array->GetNumberOfTuples() == this->Image->GetNumberOfPoints() &&
      array->GetNumberOfComponents() >= least && array->GetNumberOfComponents() <= most
    ? array
    : nullptr;
}

std::string SoftShadowTextures::Missing(const std::string& name, const char* components) const
{
  const bool bare = this->Image->GetPointData()->GetNumberOfArrays() == 0;
  return "the height field has no point array " + name + " of " + components + " components" +
    (bare ? "; use the filter Irradiance, Transfer or Visibility to compute light" : "");
}

std::string SoftShadowTextures::Send(PostTexture& texture, vtkOpenGLRenderWindow* window,
  vtkDataArray* array, int first, int count, bool half)
{
  this->InUse.push_back(&texture);
  if (!texture.IsStale(window, array, array->GetMTime()))
  {
    return {};
  }
  const int* size = this->Image->GetDimensions();
  ++this->Uploads;
  return ReasonUnless(texture.Upload(window, PostValues(array, first, count, size[0], size[1]),
    size[0], size[1], count, half, array, array->GetMTime()));
}

std::string SoftShadowTextures::SendIrradiance(
  const std::string& name, vtkOpenGLRenderWindow* window)
{
  if (!this->IrradianceTexture)
  {
    vtkDataArray* array = this->Find(name, 3, 3);
    return array ? this->Send(this->Irradiance, window, array, 0, 3, false)
                 : this->Missing(name, "3");
  }
  if (this->IrradianceTexture->GetContext() != window || this->IrradianceTexture->GetHandle() == 0)
  {
    return "the irradiance texture is not one of this window's";
  }
  this->Irradiance.Borrow(this->IrradianceTexture);
  this->InUse.push_back(&this->Irradiance);
  return {};
}

std::string SoftShadowTextures::SendHarmonics(
  const std::string& name, vtkOpenGLRenderWindow* window)
{
  constexpr int count = static_cast<int>(LightCoefficients);
  vtkDataArray* array = this->Find(name, count, count);
  std::string reason = array ? "" : this->Missing(name, "16");
  for (int k = 0; k < 4 && reason.empty(); ++k)
  {
    reason =
      this->Send(this->Harmonics[static_cast<std::size_t>(k)], window, array, 4 * k, 4, true);
  }
  return reason;
}

std::string SoftShadowTextures::SendGradients(
  const std::string& name, vtkOpenGLRenderWindow* window)
{
  vtkDataArray* heights = this->Find(name, 1, 1);
  heights = heights ? heights : this->Image->GetPointData()->GetScalars();
  if (!heights || heights->GetNumberOfComponents() != 1 ||
    heights->GetNumberOfTuples() != this->Image->GetNumberOfPoints())
  {
    return this->Missing(name, "1");
  }
  this->InUse.push_back(&this->Gradient);
  if (!this->Gradient.IsStale(window, heights, heights->GetMTime()))
  {
    return {};
  }
  const int* size = this->Image->GetDimensions();
  ++this->Uploads;
  try
  {
    return ReasonUnless(this->Gradient.Upload(window, PostGradients(this->Image, heights), size[0],
      size[1], 2, false, heights, heights->GetMTime()));
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

std::string SoftShadowTextures::SendReceiver(vtkOpenGLRenderWindow* window)
{
  std::string reason = this->Receiver.Prepare(window, this->Image, this->Uploads);
  if (reason.empty())
  {
    this->InUse.push_back(&this->Receiver.Texture);
  }
  return reason;
}

} // namespace skyline
