// SPDX-License-Identifier: BSD-3-Clause
#include "GdalErrors.h"

#include "IoFailure.h"

#include <gdal.h>

#include <algorithm>
#include <cstdio>
#include <exception>
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
  self->Failed = self->Failed || kind > CE_Warning;
  try
  {
    self->KeepText(kind, message ? message : "");
  }
  catch (const std::exception&)
  {
    // There is no memory for the message. GDAL is C code, through which no exception may pass.
  }
}

void GdalErrors::KeepText(CPLErr kind, const char* message)
{
  if (kind == CE_Warning)
  {
    const std::string line = FirstLine(message);
    if (!line.empty() && this->Warnings.size() < MostWarnings &&
      std::find(this->Warnings.begin(), this->Warnings.end(), line) == this->Warnings.end())
    {
      this->Warnings.push_back(line);
    }
    return;
  }
  if (kind == CE_Fatal)
  {
    // GDAL calls abort after this message, for instance if there is no memory for one of its own
    // tables.
    std::fprintf(stderr, "skyline: GDAL ends the program: %s\n", *message ? message : "no reason");
  }
  if (this->Message.empty())
  {
    this->Message = FirstLine(message);
  }
}

} // namespace skyline
