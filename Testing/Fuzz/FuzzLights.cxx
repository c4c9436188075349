// SPDX-License-Identifier: BSD-3-Clause
// Runs libFuzzer on the values of --lamp, --sun, --time, --sun-radius, --environment, --rotation
// and --sun-irradiance. They must be either refused in one line or describe lights that can light a
// field.
#include "Failure.h"
#include "FuzzTesting.h"
#include "LightOptions.h"
#include "Lights.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkHeightFieldIrradiance.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSkylineLight.h"

#include <CLI/CLI.hpp>
#include <fuzzer/FuzzedDataProvider.h>

#include <cmath>
#include <vector>

namespace
{

vtkSmartPointer<vtkImageData> Terrain()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(5, 4, 1);
  image->SetSpacing(10.0, 10.0, 1.0);
  vtkNew<vtkDoubleArray> heights;
  for (int post = 0; post < 20; ++post)
  {
    heights->InsertNextValue(7.0 * (post * 5 % 9));
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  using skyline::testing::Demand;
  static const skyline::testing::FuzzFolder folder;
  static const vtkSmartPointer<vtkImageData> terrain = Terrain();
  const char* const names[] = { "--lamp", "--sun", "--time", "--sun-radius", "--environment",
    "--rotation", "--sun-irradiance", "--limb-darkening" };
  FuzzedDataProvider input(bytes, size);
  std::vector<std::string> arguments;
  const int count = input.ConsumeIntegralInRange(1, 5);
  for (int k = 0; k < count; ++k)
  {
    const std::string name = input.PickValueInArray(names);
    std::string value = input.ConsumeRandomLengthString(40);
    for (char& letter : value)
    {
      letter = letter == '/' ? '_' : letter; // only files of the working folder, which is empty
    }
    arguments.insert(arguments.begin(), name == "--limb-darkening" ? name : name + "=" + value);
  }

  skyline::LightDescription asked;
  CLI::App command;
  skyline::AddLightOptions(command, asked);
  try
  {
    command.parse(arguments);
    skyline::CommonOptions common;
    common.Quiet = true;
    const auto lights = skyline::MakeLights(asked, terrain, common);
    vtkNew<vtkHeightFieldIrradiance> irradiance;
    irradiance->SetInputData(terrain);
    irradiance->SetNumberOfAzimuths(4);
    irradiance->RefineOff();
    for (const auto& light : lights)
    {
      irradiance->AddLight(light);
    }
    skyline::testing::UpdateQuietly(irradiance);
    vtkDataArray* found = irradiance->GetOutput()->GetPointData()->GetArray("Irradiance");
    for (vtkIdType post = 0; found != nullptr && post < found->GetNumberOfTuples(); ++post)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        const double value = found->GetComponent(post, channel);
        Demand(!std::isnan(value) && value >= 0.0, "light that is a number and not negative");
      }
    }
  }
  catch (const CLI::Error&)
  {
  }
  catch (const std::exception& reason)
  {
    Demand(*reason.what() != '\0', "a reason");
  }
  return 0;
}
