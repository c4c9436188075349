// SPDX-License-Identifier: BSD-3-Clause
// Runs libFuzzer on the whole command line: any options of any command, with three rasters, of
// which one is valid. The program must end with the status 0, 1 or 2, and must leave an output file
// only with 0.
#include "FuzzTesting.h"
#include "Interrupt.h"

#include <gdal_priv.h>

#include <fuzzer/FuzzedDataProvider.h>

#include <fcntl.h>
#include <vector>

int SkylineMain(int argc, char** argv); // Tools/Commands/Main.cxx, renamed

// Replaces Tools/Shared/Interrupt.cxx, whose use of the alarm signal would stop the clock of
// libFuzzer.
namespace skyline
{
void CatchInterrupts() {}
bool Interrupted()
{
  return false;
}
void StopIfInterrupted() {}
void EndIfInterrupted() {}
} // namespace skyline

namespace
{

// Numbers that are not allowed, because one run would then take hours: many azimuths or threads.
bool Costly(const std::string& text)
{
  return text.find_first_of("eExX") != std::string::npos || text.size() > 3;
}

void MakeTerrain(const std::string& file)
{
  GDALAllRegister();
  auto* driver = static_cast<GDALDriver*>(GDALGetDriverByName("GTiff"));
  GDALDataset* raster = driver->Create(file.c_str(), 6, 5, 1, GDT_Float32, nullptr);
  OGRSpatialReference system;
  system.SetFromUserInput("EPSG:32610");
  raster->SetSpatialRef(&system);
  double transform[6] = { 5.0e5, 30.0, 0.0, 5.0e6, 0.0, -30.0 };
  raster->SetGeoTransform(transform);
  float heights[30];
  for (int post = 0; post < 30; ++post)
  {
    heights[post] = static_cast<float>(post * 7 % 11) * 10.0f;
  }
  (void)raster->GetRasterBand(1)->RasterIO(
    GF_Write, 0, 0, 6, 5, heights, 6, 5, GDT_Float32, 0, 0, nullptr);
  GDALClose(raster);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  using skyline::testing::Demand;
  static const skyline::testing::FuzzFolder folder;
  static const bool made = (MakeTerrain(folder.File("dem.tif")),
    skyline::testing::WriteBytes(
      folder.File("text.tif"), reinterpret_cast<const std::uint8_t*>("none"), 4),
    true);
  (void)made;
  const char* const commands[] = { "horizon", "sky-view", "sun", "shadow-height", "irradiance",
    "shade", "view", "" };
  const char* const rasters[] = { "dem.tif", "dem.tif", "dem.tif", "text.tif", "missing.tif" };
  const char* const outputs[] = { "out.tif", "out.png", "out.exr", "out.txt", "dem.tif" };
  const char* const options[] = { "--azimuths", "--method", "--surface", "--flat", "--refraction",
    "--tolerance", "--band", "--cloud-optimized", "--quantity", "--time", "--sun", "--sun-radius",
    "--limb-darkening", "--environment", "--rotation", "--lamp", "--sun-irradiance", "--horizontal",
    "--colors", "--soft", "--threads", "--verbose", "--quiet", "--help", "--version",
    "--exposure" };
  FuzzedDataProvider input(bytes, size);
  std::vector<std::string> words{ "skyline", input.PickValueInArray(commands),
    input.PickValueInArray(rasters), "-o", input.PickValueInArray(outputs) };
  const std::string output = words.back();
  const int count = input.ConsumeIntegralInRange(0, 5);
  for (int k = 0; k < count; ++k)
  {
    const std::string option =
      input.ConsumeBool() ? input.PickValueInArray(options) : input.ConsumeRandomLengthString(8);
    std::string value = input.ConsumeRandomLengthString(24);
    for (char& letter : value)
    {
      letter = letter == '/' || letter == '\0' ? '_' : letter; // stays in its folder
    }
    if ((option == "--azimuths" || option == "--threads") && Costly(value))
    {
      continue;
    }
    // The options for output files are those above.
    if (option.rfind("-o", 0) == 0 || option.rfind("--o", 0) == 0 ||
      option.find('/') != std::string::npos || option.find('\0') != std::string::npos)
    {
      continue;
    }
    words.push_back(option);
    if (input.ConsumeBool())
    {
      words.push_back(value);
    }
  }
  std::vector<char*> arguments;
  for (std::string& word : words)
  {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);

  // Its messages are discarded.
  const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
  const int said = dup(STDERR_FILENO), printed = dup(STDOUT_FILENO);
  dup2(nothing, STDERR_FILENO);
  dup2(nothing, STDOUT_FILENO);
  const int code = SkylineMain(static_cast<int>(words.size()), arguments.data());
  std::fflush(stdout);
  dup2(said, STDERR_FILENO);
  dup2(printed, STDOUT_FILENO);
  close(nothing);
  close(said);
  close(printed);

  Demand(code >= 0 && code <= 2, "an exit status of 0, 1 or 2");
  if (output != "dem.tif")
  {
    const bool left = std::filesystem::exists(output);
    Demand(!left || code == 0, "no file after a failure");
    std::filesystem::remove(output);
  }
  Demand(std::filesystem::file_size("dem.tif") > 100, "an input that is left alone");
  return 0;
}
