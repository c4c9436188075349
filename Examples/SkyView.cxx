// SPDX-License-Identifier: BSD-3-Clause
// How much sky does each post of a DEM see? A post is the centre of a raster pixel with its height.
//
// Usage: SkyView DEM OUT.tif
#include "vtkHeightFieldReader.h"
#include "vtkHeightFieldSkyView.h"
#include "vtkHeightFieldWriter.h"
#include "vtkNew.h"

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: SkyView DEM OUT.tif\n";
    return 2;
  }

  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(argv[1]);

  vtkNew<vtkHeightFieldSkyView> skyView;
  skyView->SetInputConnection(reader->GetOutputPort());
  skyView->SetNumberOfAzimuths(36);

  vtkNew<vtkHeightFieldWriter> writer;
  writer->SetInputConnection(skyView->GetOutputPort());
  writer->SetFileName(argv[2]);
  return writer->Write() ? EXIT_SUCCESS : EXIT_FAILURE;
}
