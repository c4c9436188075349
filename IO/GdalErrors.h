// SPDX-License-Identifier: BSD-3-Clause
// Messages of GDAL, stored instead of printed.
#ifndef skyline_GdalErrors_h
#define skyline_GdalErrors_h

#include <cpl_conv.h>
#include <cpl_error.h>

#include <cstddef>
#include <string>
#include <vector>

namespace skyline
{

/// While an object of this class exists, GDAL prints nothing from this thread and starts no other
/// threads. The first failure is stored (later ones only report its consequences), and so is every
/// warning. The first object registers GDAL's drivers.
class GdalErrors
{
public:
  GdalErrors();
  ~GdalErrors();
  GdalErrors(const GdalErrors&) = delete;
  GdalErrors& operator=(const GdalErrors&) = delete;

  /// True once GDAL reported a failure; warnings do not count.
  bool Any() const { return this->Failed; }

  /// The first line of the first failure, or `otherwise` if GDAL gave no text.
  std::string First(const std::string& otherwise = "GDAL gives no reason") const;

  /// The first line of each warning, without repetitions.
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

  /// Forgets all failures and warnings.
  void Clear();

private:
  static void CPL_STDCALL Keep(CPLErr kind, CPLErrorNum number, const char* message);
  void KeepText(CPLErr kind, const char* message);

  static constexpr std::size_t MostWarnings = 20; ///< a damaged file may cause one for each block

  // GDAL would use every processor, and would wait forever if the system gives it no thread.
  CPLConfigOptionSetter Alone{ "GDAL_NUM_THREADS", "1", false };
  bool Failed = false;
  std::string Message;
  std::vector<std::string> Warnings;
};

} // namespace skyline

#endif
