// SPDX-License-Identifier: BSD-3-Clause
// A file that can be read only once, kept so that it can be read as often as a reader needs.
#ifndef skyline_StreamSpool_h
#define skyline_StreamSpool_h

#include <functional>
#include <memory>
#include <string>

namespace skyline
{

/// The bytes of a pipe, a terminal or a socket in a temporary file without a name.
class StreamSpool
{
public:
  /// Seconds that a named pipe may have no writer, and that a stream may stay silent.
  static constexpr double WriterPatience = 10.0;
  static constexpr double SilencePatience = 600.0;

  /// True for standard input by its names (/vsistdin/, /dev/stdin) and for named pipes and sockets.
  static bool IsStream(const std::string& file);

  /// Reads all of it. `goOn` is asked ten times a second, and false stops with IoAborted. Throws
  /// IoFailure where nobody writes, nothing comes or the disk is full. Standard input is read once in
  /// a program: who asks again gets the same bytes.
  static std::shared_ptr<StreamSpool> Read(
    const std::string& file, const std::function<bool()>& goOn);

  ~StreamSpool();
  StreamSpool(const StreamSpool&) = delete;
  StreamSpool& operator=(const StreamSpool&) = delete;

  /// What to call the bytes, as a path.
  std::string GetName() const;

private:
  explicit StreamSpool(int file)
    : File(file)
  {
  }

  int File; ///< descriptor
};

} // namespace skyline

#endif
