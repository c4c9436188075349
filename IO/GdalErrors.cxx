// SPDX-License-Identifier: BSD-3-Clause
#include "GdalErrors.h"

#include "IoFailure.h"

#include <gdal.h>

#include <algorithm>
#include <cstdio>
#include <mutex>

namespace skyline
{

GdalErrors::GdalErrors()
{
  static std::once_flag registered;
  std::call_once(registered, [] { GDALAllRegister(); });
  CPLPushErrorHandlerEx(&GdalErrors::Keep, this);
}

GdalErrors::~GdalErrors()
{
  CPLPopErrorHandler();
}

std::string GdalErrors::First(const std::string& otherwise) const
{
  return this->Message.empty() ? otherwise : this->Message;
}

void GdalErrors::Clear()
{
  this->Failed = false;
  this->Message.clear();
  this->Warnings.clear();
}

void GdalErrors::Keep(CPLErr kind, CPLErrorNum, const char* message)
{
  auto* self = static_cast<GdalErrors*>(CPLGetErrorHandlerUserData());
  if (!self || kind < CE_Warning)
  {
    return;
  }
  if (kind == CE_Warning)
  {
    const std::string line = FirstLine(message ? message : "");
    auto& known = self->Warnings;
    if (!line.empty() && std::find(known.begin(), known.end(), line) == known.end())
    {
      known.push_back(line);
    }
    return;
  }
  self->Failed = true;
  if (kind == CE_Fatal)
  {
    // GDAL calls abort next, as it does where memory for a table of its own is missing.
    std::fprintf(stderr, "skyline: GDAL ends the program: %s\n", message ? message : "no reason");
  }
  if (self->Message.empty() && message)
  {
    self->Message = FirstLine(message);
  }
}

} // namespace skyline
