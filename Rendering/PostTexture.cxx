// SPDX-License-Identifier: BSD-3-Clause
#include "PostTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace
{

// OpenGL's GL_RG16F and GL_RGBA16F. Its header belongs to a loader that differs between VTK
// versions.
constexpr unsigned int HalfPair = 0x822F;
constexpr unsigned int HalfQuad = 0x881A;

// Posts with `components` numbers each, and which of them already have a value.
struct Field
{
  std::vector<float>& Values;
  std::ptrdiff_t Columns, Rows;
  std::size_t Components;
  std::vector<char> Known;

  bool Has(std::ptrdiff_t column, std::ptrdiff_t row) const
  {
    return column >= 0 && column < this->Columns && row >= 0 && row < this->Rows &&
      this->Known[static_cast<std::size_t>(row * this->Columns + column)] != 0;
  }
  float* At(std::ptrdiff_t column, std::ptrdiff_t row)
  {
    return this->Values.data() +
      static_cast<std::size_t>(row * this->Columns + column) * this->Components;
  }
};

// Sets a post to the mean of its finite neighbours; false if there is none.
bool TakeMean(Field& field, std::ptrdiff_t column, std::ptrdiff_t row)
{
  float* to = field.At(column, row);
  std::fill_n(to, field.Components, 0.0f);
  float count = 0.0f;
  for (std::ptrdiff_t dy = -1; dy <= 1; ++dy)
  {
    for (std::ptrdiff_t dx = -1; dx <= 1; ++dx)
    {
      if (field.Has(column + dx, row + dy))
      {
        const float* from = field.At(column + dx, row + dy);
        std::transform(to, to + field.Components, from, to, [](float a, float b) { return a + b; });
        count += 1.0f;
      }
    }
  }
  for (std::size_t c = 0; c < field.Components && count > 0.0f; ++c)
  {
    to[c] /= count;
  }
  return count > 0.0f;
}

// Copies the value of the previous column or row, in the order of a sweep, to posts without a
// value.
void Copy(Field& field, std::ptrdiff_t column, std::ptrdiff_t row, std::ptrdiff_t step)
{
  const bool beside = field.Has(column - step, row);
  if (!field.Has(column, row) && (beside || field.Has(column, row - step)))
  {
    std::copy_n(beside ? field.At(column - step, row) : field.At(column, row - step),
      field.Components, field.At(column, row));
    field.Known[static_cast<std::size_t>(row * field.Columns + column)] = 1;
  }
}

} // namespace

namespace skyline
{

void FillMissing(
  std::vector<float>& values, std::size_t columns, std::size_t rows, std::size_t components)
{
  Field field{ values, static_cast<std::ptrdiff_t>(columns), static_cast<std::ptrdiff_t>(rows),
    components, std::vector<char>(columns * rows) };
  std::vector<std::size_t> missing;
  for (std::size_t post = 0; post < columns * rows; ++post)
  {
    const float* begin = values.data() + post * components;
    field.Known[post] =
      std::all_of(begin, begin + components, [](float v) { return std::isfinite(v); }) ? 1 : 0;
    if (field.Known[post] == 0)
    {
      missing.push_back(post);
    }
  }
  std::vector<std::size_t> rim;
  for (const std::size_t post : missing)
  {
    if (TakeMean(field, static_cast<std::ptrdiff_t>(post % columns),
          static_cast<std::ptrdiff_t>(post / columns)))
    {
      rim.push_back(post);
    }
  }
  if (rim.size() == missing.size())
  {
    return;
  }
  for (const std::size_t post : rim)
  {
    field.Known[post] = 1;
  }
  for (const std::size_t post : missing)
  {
    Copy(field, static_cast<std::ptrdiff_t>(post % columns),
      static_cast<std::ptrdiff_t>(post / columns), 1);
  }
  for (auto post = missing.rbegin(); post != missing.rend(); ++post)
  {
    Copy(field, static_cast<std::ptrdiff_t>(*post % columns),
      static_cast<std::ptrdiff_t>(*post / columns), -1);
  }
}

PostTexture::PostTexture(const char* uniform)
  : Uniform(uniform)
{
}

PostTexture::~PostTexture() = default;

bool PostTexture::IsStale(
  vtkOpenGLRenderWindow* window, const void* source, vtkMTimeType time) const
{
  return !this->Texture || this->Texture->GetHandle() == 0 ||
    this->Texture->GetContext() != window || this->Source != source || this->Time != time;
}

bool PostTexture::Upload(vtkOpenGLRenderWindow* window, const std::vector<float>& values,
  int columns, int rows, int components, bool half, const void* source, vtkMTimeType time)
{
  this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  this->Texture->SetContext(window);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  if (half)
  {
    this->Texture->SetInternalFormat(components == 2 ? HalfPair : HalfQuad);
  }
  this->Source = source;
  this->Time = time;
  this->Borrowed = false;
  return this->Texture->Create2DFromRaw(static_cast<unsigned int>(columns),
    static_cast<unsigned int>(rows), components, VTK_FLOAT, const_cast<float*>(values.data()));
}

void PostTexture::Borrow(vtkTextureObject* texture)
{
  this->Texture = texture;
  this->Source = texture;
  this->Borrowed = true;
}

void PostTexture::Activate()
{
  this->Texture->Activate();
}

void PostTexture::Deactivate()
{
  this->Texture->Deactivate();
}

int PostTexture::GetUnit()
{
  return this->Texture->GetTextureUnit();
}

void PostTexture::Release(vtkWindow* window)
{
  if (this->Texture && !this->Borrowed)
  {
    this->Texture->ReleaseGraphicsResources(window);
  }
  this->Texture = nullptr;
}

} // namespace skyline
