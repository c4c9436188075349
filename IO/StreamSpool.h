// SPDX-License-Identifier: BSD-3-Clause
// A copy of a file that can be read only once, so that a reader can read it several times.
#ifndef skyline_StreamSpool_h
#define skyline_StreamSpool_h

#include <functional>
#include <memory>
#include <string>

namespace skyline
{

/// The bytes of a pipe, a terminal or a socket, copied to a temporary file without a name.
class StreamSpool
{
public:
  /// How long a named pipe may have no writer, and how long a stream may send nothing, in seconds.
  static constexpr double WriterPatience = 10.0;
  static constexpr double SilencePatience = 600.0;

  /// True for the names of standard input (/vsistdin/, /dev/stdin) and for named pipes and sockets.
  static bool IsStream(const std::string& file);

  /// Reads the whole stream. `goOn` is called ten times a second; if it returns false, the reading
  /// stops with IoAborted. Throws IoFailure if no program writes to the stream, if no bytes arrive,
  /// or if the disk is full. Standard input is read once in a process; later calls return the same
  /// bytes.
  static std::shared_ptr<StreamSpool> Read(
    const std::string& file, const std::function<bool()>& goOn);

  ~StreamSpool();
  StreamSpool(const StreamSpool&) = delete;
  StreamSpool& operator=(const StreamSpool&) = delete;

  /// A path under which the bytes can be read.
  std::string GetName() const;

private:
  explicit StreamSpool(int file)
    : File(file)
  {
  }

  int File; ///< a file descriptor
};

} // namespace skyline

#endif
