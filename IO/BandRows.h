// SPDX-License-Identifier: BSD-3-Clause
// Rows of arrays with the order and the numbers of a raster file.
#ifndef skyline_BandRows_h
#define skyline_BandRows_h

#include "GeoTiffFile.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace skyline
{

/// Calls worker(array) with the concrete type of the array if VTK's dispatch knows that type.
template <typename Worker>
void DispatchArray(vtkDataArray* array, Worker& worker)
{
  if (!vtkArrayDispatch::Dispatch::Execute(array, worker))
  {
    worker(array);
  }
}

/// Copies rows of the components of one array into a band-sequential buffer, top row first.
template <typename T>
struct RowCopier
{
  T* Buffer = nullptr;
  std::vector<int> Components; ///< the components that are bands here, in order
  std::size_t BandStride = 0;
  int Columns = 0;
  int TopRow = 0; ///< the first row to copy, counted from the southern edge of the image
  int Count = 0;  ///< the number of rows
  T Nodata = T(0);

  template <typename ArrayT>
  void operator()(ArrayT* array) const
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    for (int line = 0; line < this->Count; ++line)
    {
      const vtkIdType first = static_cast<vtkIdType>(this->TopRow - line) * this->Columns;
      T* row = this->Buffer + static_cast<std::size_t>(line) * this->Columns;
      for (int column = 0; column < this->Columns; ++column)
      {
        const auto tuple = tuples[first + column];
        T* to = row + column;
        for (const int component : this->Components)
        {
          const auto value = static_cast<T>(tuple[component]);
          *to = std::isfinite(value) ? value : this->Nodata;
          to += this->BandStride;
        }
      }
    }
  }
};

/// Fills `buffer` with the rows [row, row + count), counted from the top, of the bands [first,
/// first + bands), counted from 0. Missing posts get `nodata`. Each band begins bandStride numbers
/// after the one before.
template <typename T>
void GatherRows(const GeoTiffContent& content, double nodata, T* buffer, std::size_t bandStride,
  int row, int count, int first, int bands)
{
  auto band = content.Bands.begin() + first;
  const auto end = band + bands;
  while (band != end)
  {
    // Consecutive bands of one array are copied together, in one loop over the array.
    vtkDataArray* array = band->Array;
    RowCopier<T> copier;
    copier.Buffer = buffer;
    copier.BandStride = bandStride;
    copier.Columns = content.Columns;
    copier.TopRow = content.Rows - 1 - row;
    copier.Count = count;
    copier.Nodata = static_cast<T>(nodata);
    for (; band != end && band->Array == array; ++band)
    {
      copier.Components.push_back(band->Component);
      buffer += bandStride;
    }
    DispatchArray(array, copier);
  }
}

} // namespace skyline

#endif
