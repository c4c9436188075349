// SPDX-License-Identifier: BSD-3-Clause
#include "GrassLocation.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace skyline
{
namespace benchmark
{

namespace fs = std::filesystem;

GrassLocation::GrassLocation(const oracle::OracleField& field, const std::string& base)
  : Field(field)
  , Base(base)
{
  fs::create_directories(this->Mapset());
  std::ofstream(this->File("session")) << "GISDBASE: " << this->Folder.Path().string()
                                       << "\nLOCATION_NAME: place\nMAPSET: PERMANENT\nGUI: text\n";
  std::ofstream(this->Mapset() / "PROJ_INFO")
    << "name: Local\nproj: tmerc\nlat_0: 0\nlon_0: 0\nk: 1\nx_0: 0\ny_0: 0\nellps: sphere\n"
       "no_defs: defined\n";
  std::ofstream(this->Mapset() / "PROJ_UNITS") << "unit: meter\nunits: meters\nmeters: 1\n";
  for (const char* window : { "DEFAULT_WIND", "WIND" })
  {
    std::ofstream(this->Mapset() / window)
      << "proj: 99\nzone: 0\nnorth: " << this->North() << "\nsouth: " << -this->North()
      << "\neast: " << this->East() << "\nwest: " << -this->East() << "\ncols: " << field.Columns
      << "\nrows: " << field.Rows << "\ne-w resol: " << field.SpacingX
      << "\nn-s resol: " << field.SpacingY << "\ntop: 1\nbottom: 0\ncols3: " << field.Columns
      << "\nrows3: " << field.Rows << "\ndepths: 1\ne-w resol3: " << field.SpacingX
      << "\nn-s resol3: " << field.SpacingY << "\nt-b resol: 1\n";
  }
  setenv("GISBASE", base.c_str(), 1);
  setenv("GISRC", this->File("session").c_str(), 1);
  setenv("LD_LIBRARY_PATH", (base + "/lib").c_str(), 1);
}

Cost GrassLocation::Run(const std::string& module, std::vector<std::string> arguments) const
{
  arguments.insert(arguments.begin(), this->Base + "/bin/" + module);
  return RunProgram(std::move(arguments));
}

void GrassLocation::Import(const std::string& raster, const std::vector<double>& values) const
{
  std::ofstream file(this->File("posts"), std::ios::binary);
  for (std::ptrdiff_t row = this->Field.Rows - 1; row >= 0; --row) // starting in the north
  {
    for (std::ptrdiff_t column = 0; column < this->Field.Columns; ++column)
    {
      const double given = values[this->Field.Index(column, row)];
      const float value = std::isfinite(given) ? static_cast<float>(given) : Null;
      file.write(reinterpret_cast<const char*>(&value), sizeof value);
    }
  }
  file.close();
  this->Run("r.in.bin",
    { "-f", "input=" + this->File("posts"), "output=" + raster, "order=native",
      "anull=" + std::to_string(Null), "north=" + std::to_string(this->North()),
      "south=" + std::to_string(-this->North()), "east=" + std::to_string(this->East()),
      "west=" + std::to_string(-this->East()), "rows=" + std::to_string(this->Field.Rows),
      "cols=" + std::to_string(this->Field.Columns) });
}

std::vector<float> GrassLocation::Take(const std::string& prefix) const
{
  // The module adds the angle to the name, in a form that depends on the release.
  std::string raster;
  for (const auto& entry : fs::directory_iterator(this->Mapset() / "cell"))
  {
    const std::string name = entry.path().filename().string();
    raster = name.rfind(prefix, 0) == 0 ? name : raster;
  }
  if (raster.empty())
  {
    throw std::runtime_error("no raster " + prefix);
  }
  this->Run("r.out.bin",
    { "-f", "input=" + raster, "output=" + this->File("values"), "order=native",
      "null=" + std::to_string(Null) });
  fs::remove(this->Mapset() / "fcell" / raster); // for rasters of floats
  fs::remove(this->Mapset() / "cell" / raster);  // for all rasters
  std::vector<float> values(this->Field.Heights.size());
  std::ifstream file(this->File("values"), std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(values.data()),
        static_cast<std::streamsize>(values.size() * sizeof(float))))
  {
    throw std::runtime_error("r.out.bin wrote too little");
  }
  return values;
}

double GrassLocation::North() const
{
  return 0.5 * static_cast<double>(this->Field.Rows) * this->Field.SpacingY;
}

double GrassLocation::East() const
{
  return 0.5 * static_cast<double>(this->Field.Columns) * this->Field.SpacingX;
}

} // namespace benchmark
} // namespace skyline
