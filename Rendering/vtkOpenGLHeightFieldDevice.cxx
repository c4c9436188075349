// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLHeightFieldDevice.h"

#include "GpuDevice.h"
#include "GpuHorizons.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"

vtkStandardNewMacro(vtkOpenGLHeightFieldDevice);

vtkOpenGLHeightFieldDevice::vtkOpenGLHeightFieldDevice()
  : Device(std::make_unique<skyline::GpuDevice>())
{
}

vtkOpenGLHeightFieldDevice::~vtkOpenGLHeightFieldDevice() = default;

void vtkOpenGLHeightFieldDevice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RenderWindow: " << this->Device->GetWindow() << "\n"
     << indent << "TextureLimit: " << this->TextureLimit << "\n"
     << indent << "MemoryLimit: " << this->MemoryLimit << "\n"
     << indent << "Generation: " << this->Generation << "\n"
     << indent << "Reason: " << this->Reason << "\n";
}

void vtkOpenGLHeightFieldDevice::SetRenderWindow(vtkRenderWindow* window)
{
  if (window != this->Device->GetWindow())
  {
    this->Device->SetWindow(window);
    this->Modified();
  }
}

vtkRenderWindow* vtkOpenGLHeightFieldDevice::GetRenderWindow()
{
  return this->Device->GetWindow();
}

bool vtkOpenGLHeightFieldDevice::IsAvailable()
{
  bool renewed = false;
  this->Reason.clear();
  const bool open = this->Device->Open(this->Reason, renewed);
  this->Generation += renewed ? 1 : 0;
  return open;
}

std::string vtkOpenGLHeightFieldDevice::GetReason()
{
  return this->Reason;
}

std::string vtkOpenGLHeightFieldDevice::GetName()
{
  return this->IsAvailable() ? this->Device->Name() : std::string();
}

skyline::GpuDevice& vtkOpenGLHeightFieldDevice::Gpu()
{
  return *this->Device;
}

skyline::GpuLimits vtkOpenGLHeightFieldDevice::Limits() const
{
  skyline::GpuLimits limits;
  limits.Side = this->TextureLimit;
  limits.Memory = static_cast<std::size_t>(this->MemoryLimit) << 20;
  return limits;
}
