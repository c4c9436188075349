// SPDX-License-Identifier: BSD-3-Clause
// GDAL's complaints, kept instead of printed.
#ifndef skyline_GdalErrors_h
#define skyline_GdalErrors_h

#include <cpl_conv.h>
#include <cpl_error.h>

#include <cstddef>
#include <string>
#include <vector>

namespace skyline
{

/// While one lives, GDAL prints nothing from this thread and starts no others. Its first failure is remembered, for the
/// later ones only say that something did not work, and every warning. The first one made registers
/// GDAL's drivers.
class GdalErrors
{
public:
  GdalErrors();
  ~GdalErrors();
  GdalErrors(const GdalErrors&) = delete;
  GdalErrors& operator=(const GdalErrors&) = delete;

  /// True once GDAL reported a failure; warnings do not count.
  bool Any() const { return this->Failed; }

  /// The first line of the first failure, or `otherwise` when GDAL gave no words.
  std::string First(const std::string& otherwise = "GDAL gives no reason") const;

  /// The first lines of the warnings, each once.
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

  /// Forgets what happened so far.
  void Clear();

private:
  static void CPL_STDCALL Keep(CPLErr kind, CPLErrorNum number, const char* message);
  void KeepText(CPLErr kind, const char* message);

  static constexpr std::size_t MostWarnings = 20; ///< a damaged file may give one a block

  // GDAL would take every processor, and wait for ever where the system gives it no thread.
  CPLConfigOptionSetter Alone{ "GDAL_NUM_THREADS", "1", false };
  bool Failed = false;
  std::string Message;
  std::vector<std::string> Warnings;
};

} // namespace skyline

#endif
