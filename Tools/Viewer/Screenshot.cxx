// SPDX-License-Identifier: BSD-3-Clause
#include "Screenshot.h"

#include "Color/ToneMap.h"
#include "Failure.h"
#include "RunPass.h"
#include "SkyDome.h"
#include "TerrainActors.h"

#include "vtkCameraPass.h"
#include "vtkFloatArray.h"
#include "vtkHeightFieldPictureWriter.h"
#include "vtkImageData.h"
#include "vtkImageProcessingPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPixelBufferObject.h"
#include "vtkPointData.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSkylineSoftShadowShader.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace
{

// Draws into floats and reads them back; the framebuffer of VTK has only 8 bits per channel.
class FloatPass : public vtkImageProcessingPass
{
public:
  static FloatPass* New();
  vtkTypeMacro(FloatPass, vtkImageProcessingPass);

  vtkNew<vtkFloatArray> Pixels; ///< RGB

  void Render(const vtkRenderState* state) override
  {
    vtkRenderer* renderer = state->GetRenderer();
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    const int* size = renderer->GetSize();
    vtkNew<vtkTextureObject> light;
    light->SetContext(window);
    light->Create2D(
      static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]), 4, VTK_FLOAT, false);
    vtkNew<vtkOpenGLFramebufferObject> frame;
    frame->SetContext(window);
    window->GetState()->PushFramebufferBindings();
    this->RenderDelegate(state, size[0], size[1], size[0], size[1], frame, light);
    window->GetState()->PopFramebufferBindings();

    vtkPixelBufferObject* read = light->Download();
    const vtkIdType count = static_cast<vtkIdType>(size[0]) * size[1];
    this->Pixels->SetNumberOfComponents(3);
    this->Pixels->SetNumberOfTuples(count);
    if (const auto* from = static_cast<const float*>(read->MapPackedBuffer()))
    {
      for (vtkIdType k = 0; k < count; ++k)
      {
        this->Pixels->SetTypedTuple(k, from + 4 * k);
      }
      read->UnmapPackedBuffer();
    }
    read->Delete();
    frame->ReleaseGraphicsResources(window);
    light->ReleaseGraphicsResources(window);
  }

protected:
  FloatPass() = default;
  ~FloatPass() override = default;
};
vtkStandardNewMacro(FloatPass);

// The brightest channel of lit terrain and sky; 1 if everything is dark.
float PeakOf(vtkImageData* lit, const skyline::SkyImage& sky)
{
  float peak = sky.Peak();
  auto* radiance = vtkFloatArray::SafeDownCast(lit->GetPointData()->GetArray("Radiance"));
  for (vtkIdType k = 0; radiance && k < radiance->GetNumberOfValues(); ++k)
  {
    const float value = radiance->GetValue(k);
    peak = std::isfinite(value) ? std::max(peak, value) : peak;
  }
  return peak > 0.0f ? peak : 1.0f;
}

void Write(vtkDataArray* pixels, const int* size, const std::string& file)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(size[0], size[1], 1);
  image->GetPointData()->SetScalars(pixels);
  vtkNew<vtkHeightFieldPictureWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(image);
  skyline::CommonOptions silent;
  silent.Quiet = true;
  skyline::RunPass(writer, "screenshot", silent);
}

} // namespace

namespace skyline
{

std::string FreeName(const std::string& folder, const std::string& extension)
{
  for (int number = 1;; ++number)
  {
    const auto name =
      std::filesystem::path(folder) / ("skyline-" + std::to_string(number) + extension);
    if (!std::filesystem::exists(name))
    {
      return name.string();
    }
  }
}

void WritePng(vtkRenderWindow* window, const std::string& file)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels, 0);
  if (pixels->GetNumberOfTuples() != static_cast<vtkIdType>(size[0]) * size[1])
  {
    throw Failure("OpenGL returned no picture");
  }
  Write(pixels, size, file);
}

void WriteExr(vtkRenderWindow* window, vtkRenderer* renderer, vtkSkylineSoftShadowShader* shader,
  SkyDome& sky, const std::string& file)
{
  // The shader writes codes of light up to 1, which floats keep; so the brightest light becomes 1.
  const float peak = PeakOf(shader->GetHeightField(), sky.GetSky());
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(opaque);
  vtkNew<FloatPass> pass;
  pass->SetDelegatePass(camera);
  const double exposure = shader->GetExposure();
  shader->SetExposure(ShaderExposure(-std::log2(peak)));
  shader->ToneMappingOff();
  sky.DevelopLinear(peak);
  renderer->SetPass(pass);
  window->Render();
  renderer->SetPass(nullptr);
  pass->ReleaseGraphicsResources(window);
  shader->ToneMappingOn();
  shader->SetExposure(exposure);
  float* light = pass->Pixels->GetPointer(0);
  for (vtkIdType k = 0; k < pass->Pixels->GetNumberOfValues(); ++k)
  {
    light[k] = peak * DecodeSrgb(light[k]);
  }
  Write(pass->Pixels, renderer->GetSize(), file);
}

} // namespace skyline
