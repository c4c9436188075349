// SPDX-License-Identifier: BSD-3-Clause
// A part of Mount St Helens (Testing/Data/exact) as a field of the oracle.
#ifndef skyline_RealTerrain_h
#define skyline_RealTerrain_h

#include "Reference/Oracle.h"

#include "vtkDataArray.h"
#include "vtkHeightFieldReader.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <string>

namespace skyline
{
namespace testing
{

/// 160 x 160 posts, 30 m apart, with heights of 1271 to 2543 m. The field is empty if the file
/// cannot be read.
inline oracle::OracleField SaintHelens()
{
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName((std::string(SKYLINE_TEST_DATA) + "/exact/sthelens_crop160_dem.tif").c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  vtkDataArray* heights = image->GetPointData()->GetScalars();
  if (heights == nullptr)
  {
    return {};
  }
  const int* size = image->GetDimensions();
  oracle::OracleField field(size[0], size[1], image->GetSpacing()[0], image->GetSpacing()[1]);
  for (std::size_t post = 0; post < field.Heights.size(); ++post)
  {
    field.Heights[post] = heights->GetComponent(static_cast<vtkIdType>(post), 0);
  }
  return field;
}

} // namespace testing
} // namespace skyline

#endif
