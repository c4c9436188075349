// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightFieldWriter.h"

#include "AtomicFile.h"
#include "GeoTiffFile.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHeightFieldWriter);

namespace
{

/// The greatest number of bands in a TIFF (16 bits).
constexpr int MostBands = 65535;

std::string DefaultDescription(vtkDataArray* array, int component)
{
  std::string description = array->GetName() ? array->GetName() : "";
  if (array->GetNumberOfComponents() > 1)
  {
    const char* part = array->GetComponentName(component);
    description += " " + (part ? part : std::to_string(component + 1));
  }
  return description;
}

std::string DefaultUnit(vtkDataArray* array)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  return name == "Elevation" || name.rfind("ShadowHeight", 0) == 0 ? "m" : "";
}

/// The text that was set for a band, or `otherwise`.
std::string TextOf(const std::map<int, std::string>& texts, int band, const std::string& otherwise)
{
  const auto text = texts.find(band);
  return text == texts.end() ? otherwise : text->second;
}

} // namespace

vtkHeightFieldWriter::vtkHeightFieldWriter() = default;

vtkHeightFieldWriter::~vtkHeightFieldWriter() = default;

void vtkHeightFieldWriter::AddArray(const char* name)
{
  this->ArrayNames.emplace_back(name ? name : "");
  this->Modified();
}

void vtkHeightFieldWriter::ClearArrays()
{
  this->ArrayNames.clear();
  this->Modified();
}

void vtkHeightFieldWriter::SetBandDescription(int band, const char* text)
{
  this->Descriptions[band] = text ? text : "";
  this->Modified();
}

void vtkHeightFieldWriter::SetBandUnit(int band, const char* unit)
{
  this->Units[band] = unit ? unit : "";
  this->Modified();
}

void vtkHeightFieldWriter::ClearBandTexts()
{
  this->Descriptions.clear();
  this->Units.clear();
  this->Modified();
}

void vtkHeightFieldWriter::WriteImage(vtkImageData* image, const skyline::AtomicFile& file)
{
  const std::string extension = this->GetExtension();
  if (!extension.empty() && extension != "tif" && extension != "tiff")
  {
    this->Refuse("rasters are written as GeoTIFF; end the name in .tif");
  }

  skyline::GeoTiffContent content = skyline::ContentOf(image);
  content.CloudOptimized = this->CloudOptimized;
  const std::vector<std::string> names =
    this->ArrayNames.empty() ? std::vector<std::string>{ "" } : this->ArrayNames;
  for (const std::string& name : names)
  {
    vtkDataArray* array = this->FindArray(image, name);
    for (int component = 0; component < array->GetNumberOfComponents(); ++component)
    {
      const int band = static_cast<int>(content.Bands.size()) + 1;
      content.Bands.push_back(
        { array, component, TextOf(this->Descriptions, band, DefaultDescription(array, component)),
          TextOf(this->Units, band, DefaultUnit(array)) });
    }
  }
  if (content.Bands.size() > MostBands)
  {
    this->Refuse(std::to_string(content.Bands.size()) + " bands are more than a TIFF holds (" +
      std::to_string(MostBands) + "); write fewer");
  }
  // An array of unsigned char with three or four components is a picture.
  vtkDataArray* first = content.Bands.front().Array;
  content.Picture =
    first == content.Bands.back().Array && first->GetDataType() == VTK_UNSIGNED_CHAR;
  skyline::WriteGeoTiff(content, file, [this](double part) { this->Report(part); });
}

void vtkHeightFieldWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Arrays:";
  for (const std::string& name : this->ArrayNames)
  {
    os << " " << name;
  }
  os << "\n" << indent << "CloudOptimized: " << (this->CloudOptimized ? "on" : "off") << "\n";
  for (const auto& text : this->Descriptions)
  {
    os << indent << "Band " << text.first << ": " << text.second << "\n";
  }
  for (const auto& unit : this->Units)
  {
    os << indent << "Unit of band " << unit.first << ": " << unit.second << "\n";
  }
}
