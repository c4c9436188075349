// SPDX-License-Identifier: BSD-3-Clause
// Images are read and written on the calling thread alone.
#ifndef skyline_NoImageThreads_h
#define skyline_NoImageThreads_h

#include <OpenImageIO/imageio.h>

#include <mutex>

namespace skyline
{

/// While an object of this class exists, OpenEXR starts no threads. Its threads would use every
/// processor, lose errors, and fail if the system refuses to start one. The threads of OpenImageIO
/// are avoided for each file by `threads(1)`, because setting their number globally starts some.
class NoImageThreads
{
public:
  NoImageThreads()
  {
    const std::lock_guard<std::mutex> lock(Mutex);
    if (Users++ == 0)
    {
      OIIO::getattribute("exr_threads", Before);
      OIIO::attribute("exr_threads", -1);
    }
  }
  ~NoImageThreads()
  {
    const std::lock_guard<std::mutex> lock(Mutex);
    if (--Users == 0)
    {
      OIIO::attribute("exr_threads", Before);
    }
  }
  NoImageThreads(const NoImageThreads&) = delete;
  NoImageThreads& operator=(const NoImageThreads&) = delete;

private:
  inline static std::mutex Mutex;
  inline static int Users = 0;
  inline static int Before = 0;
};

} // namespace skyline

#endif
