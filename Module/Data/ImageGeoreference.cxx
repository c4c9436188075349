// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ImageGeoreference.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <stdexcept>
#include <string>

namespace skyline
{

namespace
{

void AddNumbers(
  vtkFieldData* fields, const char* name, int components, const double* values, std::size_t tuples)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  for (std::size_t i = 0; i < tuples * static_cast<std::size_t>(components); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
  fields->AddArray(array);
}

/// Adds an array with one tuple for each pair of elements of the two lists.
void AddPairs(vtkFieldData* fields, const char* name, const std::vector<double>& first,
  const std::vector<double>& second)
{
  if (first.empty() || first.size() != second.size())
  {
    return;
  }
  std::vector<double> pairs;
  pairs.reserve(2 * first.size());
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    pairs.push_back(first[i]);
    pairs.push_back(second[i]);
  }
  AddNumbers(fields, name, 2, pairs.data(), first.size());
}

/// The array with this name, or null unless it has this number of components and at least one
/// tuple.
vtkDataArray* FindNumbers(vtkFieldData* fields, const char* name, int components)
{
  vtkDataArray* array = fields->GetArray(name);
  const bool fits =
    array && array->GetNumberOfComponents() == components && array->GetNumberOfTuples() > 0;
  return fits ? array : nullptr;
}

/// Reads the pairs of an array into two lists, unless their number differs from `expected`.
void LoadPairs(vtkFieldData* fields, const char* name, std::ptrdiff_t expected,
  std::vector<double>& first, std::vector<double>& second)
{
  vtkDataArray* array = FindNumbers(fields, name, 2);
  if (!array || array->GetNumberOfTuples() != expected)
  {
    return;
  }
  first.reserve(static_cast<std::size_t>(expected));
  second.reserve(static_cast<std::size_t>(expected));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    first.push_back(array->GetComponent(i, 0));
    second.push_back(array->GetComponent(i, 1));
  }
}

} // namespace

void StoreGeoreference(const Georeference& georeference, vtkDataObject* data)
{
  vtkFieldData* fields = data->GetFieldData();
  for (const char* name : { CrsArrayName, GeoTransformArrayName, BodyArrayName, LatticeArrayName,
         LatticeSizeArrayName, RowSpacingArrayName, DegreesArrayName, PostCountArrayName })
  {
    fields->RemoveArray(name);
  }

  if (!georeference.Crs.empty())
  {
    vtkNew<vtkStringArray> crs;
    crs->SetName(CrsArrayName);
    crs->InsertNextValue(georeference.Crs);
    fields->AddArray(crs);
  }
  if (georeference.HasGeoTransform)
  {
    AddNumbers(fields, GeoTransformArrayName, 6, georeference.GeoTransform.data(), 1);
  }
  if (georeference.EquatorialRadius > 0.0)
  {
    const double body[3] = { georeference.EquatorialRadius, georeference.Flattening,
      georeference.Earth ? 1.0 : 0.0 };
    AddNumbers(fields, BodyArrayName, 3, body, 1);
  }
  if (!georeference.Longitude.empty())
  {
    vtkNew<vtkIntArray> size;
    size->SetName(LatticeSizeArrayName);
    size->SetNumberOfComponents(2);
    size->InsertNextTuple2(georeference.LatticeColumns, georeference.LatticeRows);
    fields->AddArray(size);
    AddPairs(fields, LatticeArrayName, georeference.Longitude, georeference.Latitude);
  }
  AddPairs(fields, RowSpacingArrayName, georeference.RowSpacingX, georeference.RowSpacingY);
  if (georeference.InDegrees)
  {
    const double yes = 1.0;
    AddNumbers(fields, DegreesArrayName, 1, &yes, 1);
  }
  const double posts[2] = { static_cast<double>(georeference.Columns),
    static_cast<double>(georeference.Rows) };
  AddNumbers(fields, PostCountArrayName, 2, posts, 1);
}

Georeference GeoreferenceOf(vtkImageData* image)
{
  Georeference place = LoadGeoreference(image);
  const int* const posts = image->GetDimensions();
  if (place.Columns != posts[0] || place.Rows != posts[1])
  {
    if (place.HasGeoTransform || place.OnBody() || !place.RowSpacingX.empty())
    {
      throw std::invalid_argument("the georeference is for " + std::to_string(place.Columns) +
        " x " + std::to_string(place.Rows) + " posts, the height field has " +
        std::to_string(posts[0]) + " x " + std::to_string(posts[1]) +
        "; cut the raster before (gdal_translate -srcwin), or by the reader's extent");
    }
    place.Columns = posts[0];
    place.Rows = posts[1];
  }
  return place;
}

Georeference LoadGeoreference(vtkDataObject* data)
{
  Georeference georeference;
  if (!data)
  {
    return georeference;
  }
  vtkFieldData* fields = data->GetFieldData();

  if (vtkDataArray* posts = FindNumbers(fields, PostCountArrayName, 2))
  {
    georeference.Columns = static_cast<std::ptrdiff_t>(posts->GetComponent(0, 0));
    georeference.Rows = static_cast<std::ptrdiff_t>(posts->GetComponent(0, 1));
  }
  else if (vtkImageData* image = vtkImageData::SafeDownCast(data))
  {
    const int* dimensions = image->GetDimensions();
    georeference.Columns = dimensions[0];
    georeference.Rows = dimensions[1];
  }

  vtkStringArray* crs = vtkStringArray::SafeDownCast(fields->GetAbstractArray(CrsArrayName));
  if (crs && crs->GetNumberOfValues() > 0)
  {
    georeference.Crs = crs->GetValue(0);
  }
  if (vtkDataArray* transform = FindNumbers(fields, GeoTransformArrayName, 6))
  {
    transform->GetTuple(0, georeference.GeoTransform.data());
    georeference.HasGeoTransform = true;
  }
  if (vtkDataArray* body = FindNumbers(fields, BodyArrayName, 3))
  {
    georeference.EquatorialRadius = body->GetComponent(0, 0);
    georeference.Flattening = body->GetComponent(0, 1);
    georeference.Earth = body->GetComponent(0, 2) != 0.0;
  }
  if (vtkDataArray* size = FindNumbers(fields, LatticeSizeArrayName, 2))
  {
    const int columns = static_cast<int>(size->GetComponent(0, 0));
    const int rows = static_cast<int>(size->GetComponent(0, 1));
    LoadPairs(fields, LatticeArrayName, static_cast<std::ptrdiff_t>(columns) * rows,
      georeference.Longitude, georeference.Latitude);
    if (!georeference.Longitude.empty())
    {
      georeference.LatticeColumns = columns;
      georeference.LatticeRows = rows;
    }
  }
  vtkDataArray* degrees = FindNumbers(fields, DegreesArrayName, 1);
  georeference.InDegrees = degrees && degrees->GetComponent(0, 0) != 0.0;
  LoadPairs(fields, RowSpacingArrayName, georeference.Rows, georeference.RowSpacingX,
    georeference.RowSpacingY);
  return georeference;
}

void StoreNodataValue(double value, vtkDataObject* data)
{
  data->GetFieldData()->RemoveArray(NodataArrayName);
  AddNumbers(data->GetFieldData(), NodataArrayName, 1, &value, 1);
}

bool LoadNodataValue(vtkDataObject* data, double& value)
{
  vtkDataArray* array = data ? FindNumbers(data->GetFieldData(), NodataArrayName, 1) : nullptr;
  if (array)
  {
    value = array->GetComponent(0, 0);
  }
  return array != nullptr;
}

} // namespace skyline
