// SPDX-License-Identifier: BSD-3-Clause
// The sun over a DEM during one day: a picture for each of several hours, and all of them side by
// side.
//
// Usage: SunOverADay DEM STRIP.png [FRAMES_FOLDER]
//
// To make a film of the frames: ffmpeg -framerate 4 -i FRAMES_FOLDER/%02d.png day.mp4
#include "vtkDataArray.h"
#include "vtkHeightFieldPictureWriter.h"
#include "vtkHeightFieldReader.h"
#include "vtkHeightFieldShading.h"
#include "vtkHeightFieldSkyView.h"
#include "vtkHeightFieldSunShadow.h"
#include "vtkImageAppend.h"
#include "vtkImageData.h"
#include "vtkImageShrink3D.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkSkylineSunLight.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

namespace
{

const std::string Day[] = { "21T12:45", "21T13:15", "21T14:00", "21T16:00", "21T20:00", "22T00:00",
  "22T02:30", "22T03:30" };
constexpr int Half = 4;   // frames per row of the strip
constexpr int Shrink = 2; // so many pixels of a frame become one pixel of the strip

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 3 && argc != 4)
  {
    std::cerr << "usage: SunOverADay DEM STRIP.png [FRAMES_FOLDER]\n";
    return 2;
  }
  vtkNew<vtkHeightFieldReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHeightFieldSkyView> sky; // does not change during the day, so it is computed once
  sky->SetInputConnection(reader->GetOutputPort());
  sky->SetNumberOfAzimuths(36);
  sky->Update();

  vtkNew<vtkSkylineSunLight>
    sun; // both filters use it; it computes its position from time and place
  sun->UseTimeOn();
  vtkNew<vtkHeightFieldSunShadow> shadow;
  shadow->SetInputConnection(sky->GetOutputPort());
  shadow->SetSun(sun);
  vtkNew<vtkHeightFieldShading> shading;
  shading->SetInputConnection(shadow->GetOutputPort());
  shading->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
  shading->SetSun(sun);
  shading->AutoExposureOff(); // the same exposure for the whole day

  vtkNew<vtkImageAppend> rows[2];
  for (int frame = 0; frame < 2 * Half; ++frame)
  {
    const std::string time = "2026-06-" + Day[frame] + "Z";
    sun->SetTime(time.c_str());
    double direction[3]; // azimuth, elevation, angular radius
    if (!sun->FindDirection(reader->GetOutput(), direction))
    {
      return EXIT_FAILURE; // the reason has been printed
    }
    const double height = std::clamp(direction[1] / 25.0, 0.0, 1.0); // a low sun is weak and red
    sun->SetIrradiance(3.0 * std::pow(height, 0.4), 2.8 * std::pow(height, 0.7), 2.5 * height);
    const double blue = 0.05 + 0.15 * height;
    shading->SetSkyRadiance(0.8 * blue, 1.0 * blue, 1.35 * blue);
    shading->Update();

    vtkDataArray* lit = shadow->GetOutput()->GetPointData()->GetArray("SunVisibility");
    double sum = 0.0;
    vtkIdType posts = 0;
    for (vtkIdType i = 0; i < lit->GetNumberOfTuples(); ++i)
    {
      const double part = lit->GetComponent(i, 0);
      sum += std::isnan(part) ? 0.0 : part;
      posts += std::isnan(part) ? 0 : 1;
    }
    std::cout << time << "  azimuth " << direction[0] << "  elevation " << direction[1] << "  lit "
              << sum / static_cast<double>(posts) << "\n";

    vtkNew<vtkImageShrink3D> smaller;
    smaller->SetInputConnection(shading->GetOutputPort());
    smaller->SetShrinkFactors(Shrink, Shrink, 1);
    smaller->MeanOn();
    smaller->Update();
    vtkNew<vtkImageData> picture; // a copy, because the filters continue with the next frame
    picture->DeepCopy(smaller->GetOutput());
    rows[frame / Half]->AddInputData(picture);
    if (argc == 4)
    {
      std::filesystem::create_directories(argv[3]);
      const std::string file = std::string(argv[3]) + "/0" + std::to_string(frame) + ".png";
      vtkNew<vtkHeightFieldPictureWriter> writer;
      writer->SetInputConnection(shading->GetOutputPort());
      writer->SetFileName(file.c_str());
      writer->Write();
    }
  }

  vtkNew<vtkImageAppend> strip;
  strip->SetAppendAxis(1); // upwards
  strip->AddInputConnection(rows[1]->GetOutputPort());
  strip->AddInputConnection(rows[0]->GetOutputPort());
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(strip->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();
  return EXIT_SUCCESS;
}
