// SPDX-License-Identifier: BSD-3-Clause
#include "HeightConversion.h"

#include "IoFailure.h"
#include "LengthUnit.h"

#include "vtkErrorCode.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>

namespace skyline
{

namespace
{

/// Units that differ by less (relatively) are the same. The two definitions of the foot differ by
/// 2e-6, and units in texts are rounded.
constexpr double UnitTolerance = 1e-5;

[[noreturn]] void Refuse(const std::string& file, const std::string& reason)
{
  throw IoFailure(vtkErrorCode::FileFormatError, "cannot use '" + file + "': " + reason);
}

std::string Item(GDALMajorObject& object, const char* key)
{
  const char* value = object.GetMetadataItem(key);
  return value ? value : "";
}

std::string Small(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string Metres(double metres)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.10g m", metres);
  return text.data();
}

/// The size in metres of one unit of the band's values after scale and offset.
double ReadUnit(GDALRasterBand& band, const CoordinateSystem& crs, const std::string& file,
  std::vector<Doubt>& doubts)
{
  double metres = 0.0;
  const char* unit = band.GetUnitType();
  std::string name = unit ? unit : "";
  UnitName kind = ReadUnitName(name, metres);
  if (kind == UnitName::Unknown)
  {
    Refuse(file,
      "its heights have the unit '" + name +
        "', which is not a known length; give metres or feet (gdal_edit.py -units m)");
  }
  for (const char* key : { "units", "unit", "GRIB_UNIT" })
  {
    if (kind == UnitName::Absent)
    {
      name = Item(band, key);
      kind = ReadUnitName(name, metres);
    }
  }
  if (kind == UnitName::Unknown)
  {
    Refuse(file,
      "the metadata of its band name the unit '" + name +
        "', which is not a known length; give metres or feet (gdal_edit.py -units m)");
  }

  const double vertical = crs.GetVerticalUnit();
  if (kind == UnitName::Length)
  {
    if (vertical > 0.0 && std::abs(vertical / metres - 1.0) > UnitTolerance)
    {
      doubts.push_back({ "the heights of '" + file + "' are in '" + name +
          "' according to the band, but in units of " + Metres(vertical) + " according to the CRS",
        "the band's unit", "gdal_edit.py -units" });
    }
    return metres;
  }
  if (vertical > 0.0)
  {
    return vertical;
  }
  if (crs.IsOnMap() && std::abs(crs.GetUnit() - 1.0) > UnitTolerance)
  {
    doubts.push_back({ "the map of '" + file + "' is in units of " + Metres(crs.GetUnit()) +
        ", and the unit of its heights is not given",
      "heights in metres", "gdal_edit.py -units ft" });
  }
  return 1.0;
}

void DoubtDirection(GDALRasterBand& band, const CoordinateSystem& crs, double scale,
  const std::string& file, std::vector<Doubt>& doubts)
{
  const bool down = Small(Item(band, "positive")) == "down";
  const std::string standard = Item(band, "standard_name");
  const bool depth = standard.find("depth") != std::string::npos;
  if (scale > 0.0 && (down || depth || crs.CountsDepths()))
  {
    doubts.push_back({ std::string(down ? "the item 'positive'"
                           : depth      ? "the standard name"
                                        : "the CRS") +
        " of '" + file + "' says that its values are depths",
      "heights that count upwards", "gdal_edit.py -scale -1" });
  }
}

void DoubtPicture(
  GDALDataset& dataset, GDALRasterBand& band, const std::string& file, std::vector<Doubt>& doubts)
{
  std::string part;
  switch (band.GetColorInterpretation())
  {
    case GCI_RedBand:
      part = "the red part of a picture";
      break;
    case GCI_GreenBand:
      part = "the green part of a picture";
      break;
    case GCI_BlueBand:
      part = "the blue part of a picture";
      break;
    case GCI_PaletteIndex:
      part = "a picture with a colour table";
      break;
    case GCI_AlphaBand:
      part = "the opacity of a picture";
      break;
    default:
      return;
  }
  if (dataset.GetRasterCount() >= 3 || band.GetColorInterpretation() == GCI_PaletteIndex)
  {
    doubts.push_back({ "band " + std::to_string(band.GetBand()) + " of '" + file + "' is " + part,
      "its values are heights", "" });
  }
}

} // namespace

HeightConversion ReadHeightConversion(GDALDataset& dataset, GDALRasterBand& band,
  const CoordinateSystem& crs, const std::string& file, std::vector<Doubt>& doubts)
{
  const double metres = ReadUnit(band, crs, file, doubts);
  int found = 0;
  double scale = band.GetScale(&found);
  scale = found ? scale : 1.0;
  double offset = band.GetOffset(&found);
  offset = found ? offset : 0.0;
  if (!std::isfinite(scale) || scale == 0.0 || !std::isfinite(offset))
  {
    Refuse(file,
      "its band has the scale " + std::to_string(scale) + " and offset " + std::to_string(offset) +
        "; set usable ones (gdal_edit.py -scale -offset)");
  }
  DoubtDirection(band, crs, scale, file, doubts);
  DoubtPicture(dataset, band, file, doubts);
  return { scale * metres, offset * metres };
}

} // namespace skyline
