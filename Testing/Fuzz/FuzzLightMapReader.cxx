// SPDX-License-Identifier: BSD-3-Clause
// Runs libFuzzer on the reader of light maps, with any bytes. Values that are read must be finite
// and not negative.
#include "FuzzTesting.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkSkylineLightMapReader.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  using skyline::testing::Demand;
  static const skyline::testing::FuzzFolder folder;
  const std::string file = folder.File("map.hdr"); // the content determines the format
  skyline::testing::WriteBytes(file, bytes, size);

  vtkNew<vtkSkylineLightMapReader> reader;
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  int extent[6] = { 0, -1, 0, -1, 0, 0 };
  reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  if (static_cast<double>(extent[1] + 1) * (extent[3] + 1) > 1.0e6)
  {
    return 0; // the header may claim a large size, and the memory of the fuzzer is small
  }
  skyline::testing::UpdateQuietly(reader);
  vtkDataArray* pixels = reader->GetOutput()->GetPointData()->GetScalars();
  for (vtkIdType pixel = 0; pixels != nullptr && pixel < pixels->GetNumberOfTuples(); ++pixel)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const double value = pixels->GetComponent(pixel, channel);
      Demand(std::isfinite(value) && value >= 0.0, "radiance that is finite and not negative");
    }
  }
  return 0;
}
