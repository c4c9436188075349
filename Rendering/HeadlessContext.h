// SPDX-License-Identifier: BSD-3-Clause
// An OpenGL context that needs no window system.
#ifndef skyline_HeadlessContext_h
#define skyline_HeadlessContext_h

#include <string>

namespace skyline
{

/// An OpenGL 3.2 core context without a surface, made by EGL: on a graphics processor where EGL
/// shows one, else on Mesa's surfaceless platform. Whoever draws brings a framebuffer object.
class HeadlessContext
{
public:
  HeadlessContext() = default;
  ~HeadlessContext() { this->Destroy(); }
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  /// Whether this build knows EGL.
  static bool Built();

  /// Makes the context on EGL's device of that number, or on the best one (-1). False, and Reason
  /// says why in one line, where there is none.
  bool Create(int device);
  void Destroy();

  bool Exists() const { return this->Context != nullptr; }

  /// False where the context does not exist or the driver has lost it.
  bool MakeCurrent();
  bool IsCurrent() const;
  void Release();

  /// An OpenGL function by its name; null where there is none.
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
