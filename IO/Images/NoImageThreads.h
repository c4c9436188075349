// SPDX-License-Identifier: BSD-3-Clause
// Images are read and written by the thread that asks.
#ifndef skyline_NoImageThreads_h
#define skyline_NoImageThreads_h

#include <OpenImageIO/imageio.h>

#include <mutex>

namespace skyline
{

/// While one lives, OpenEXR starts no threads: it would take every processor, its errors would not be
/// heard, and where the system refuses a thread it fails. OpenImageIO's own are held back file by file
/// (`threads(1)`), for setting their number starts some.
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
