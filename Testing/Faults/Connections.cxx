// SPDX-License-Identifier: BSD-3-Clause
// Replaces the functions that open network connections, in a program that is linked with this file
// or that preloads it. Each call is logged and refused, so that tests can check whether a program
// tried to connect.
#include "CallLog.h"

#include <cerrno>
#include <cstddef>
#include <cstdio>

#include <arpa/inet.h>
#include <dlfcn.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/un.h>

// The compiler sees these functions under other names, because system headers declare them in
// different ways.
#define SKYLINE_INSTEAD_OF(name) __asm__(name) __attribute__((visibility("default")))

extern "C"
{
  int SkylineConnect(int, const sockaddr*, socklen_t) SKYLINE_INSTEAD_OF("connect");
  ssize_t SkylineSendTo(int, const void*, std::size_t, int, const sockaddr*, socklen_t)
    SKYLINE_INSTEAD_OF("sendto");
  int SkylineGetAddrInfo(const char*, const char*, const addrinfo*, addrinfo**)
    SKYLINE_INSTEAD_OF("getaddrinfo");
  hostent* SkylineGetHostByName(const char*) SKYLINE_INSTEAD_OF("gethostbyname");
}

namespace
{

void LogAddress(const char* what, const sockaddr* address, socklen_t size)
{
  char place[INET6_ADDRSTRLEN] = "?";
  char text[INET6_ADDRSTRLEN + 32];
  int port = 0;
  if (address && address->sa_family == AF_INET && size >= sizeof(sockaddr_in))
  {
    const auto* internet = reinterpret_cast<const sockaddr_in*>(address);
    port = ntohs(internet->sin_port);
    ::inet_ntop(AF_INET, &internet->sin_addr, place, sizeof(place));
  }
  else if (address && address->sa_family == AF_INET6 && size >= sizeof(sockaddr_in6))
  {
    const auto* internet = reinterpret_cast<const sockaddr_in6*>(address);
    port = ntohs(internet->sin6_port);
    ::inet_ntop(AF_INET6, &internet->sin6_addr, place, sizeof(place));
  }
  else if (address && address->sa_family == AF_UNIX && size > offsetof(sockaddr_un, sun_path))
  {
    skyline::testing::LogCall(what, reinterpret_cast<const sockaddr_un*>(address)->sun_path);
    return;
  }
  std::snprintf(text, sizeof(text), "%s port %d", place, port);
  skyline::testing::LogCall(what, text);
}

} // namespace

int SkylineConnect(int, const sockaddr* address, socklen_t size)
{
  LogAddress("connect", address, size);
  errno = ECONNREFUSED;
  return -1;
}

ssize_t SkylineSendTo(int file, const void* bytes, std::size_t count, int flags,
  const sockaddr* address, socklen_t size)
{
  if (address)
  {
    LogAddress("send", address, size);
    errno = ECONNREFUSED;
    return -1;
  }
  return ::send(file, bytes, count, flags);
}

int SkylineGetAddrInfo(const char* host, const char*, const addrinfo*, addrinfo**)
{
  skyline::testing::LogCall("look-up", host);
  return EAI_FAIL;
}

hostent* SkylineGetHostByName(const char* host)
{
  skyline::testing::LogCall("look-up", host);
  h_errno = NO_RECOVERY;
  return nullptr;
}
