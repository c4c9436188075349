// SPDX-License-Identifier: BSD-3-Clause
// An OpenGL context that needs no window system.
#ifndef skyline_HeadlessContext_h
#define skyline_HeadlessContext_h

#include <string>

namespace skyline
{

/// An OpenGL 3.2 core context without a surface, made by EGL: on a graphics processor if EGL lists
/// one, otherwise on Mesa's surfaceless platform. The caller must provide a framebuffer object to
/// draw into.
class HeadlessContext
{
public:
  HeadlessContext() = default;
  ~HeadlessContext() { this->Destroy(); }
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  /// Whether Skyline was built with EGL.
  static bool Built();

  /// Makes the context on the EGL device with this number, or on the best one (-1). Returns false
  /// if that fails; Reason then holds the cause in one line.
  bool Create(int device);
  void Destroy();

  bool Exists() const { return this->Context != nullptr; }

  /// Returns false if the context does not exist or the driver has lost it.
  bool MakeCurrent();
  bool IsCurrent() const;
  void Release();

  /// An OpenGL function, found by its name; null if there is none.
  using Function = void (*)();
  static Function FindFunction(const char* name);

  const std::string& GetReason() const { return this->Reason; }

private:
  bool CreateOn(void* display);

  void* Display = nullptr;
  void* Context = nullptr;
  std::string Reason;
};

} // namespace skyline

#endif
